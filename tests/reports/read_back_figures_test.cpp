#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/reports/distinct.hpp"
#include "tests/reports/read_back_drawing.hpp"

/// What stands where in the figures of a report: their values as the tics say them, their series as the key does.
namespace mpmvv::reports::read_back_figures_test {

using records::Series;
using records::StudyResult;

using read_back::close;
using read_back::Drawing;
using read_back::drawing_of;
using read_back::expect_near;
using read_back::Look;
using read_back::ReadLine;
using read_back::ReadMark;
using Kind = ReadMark::Kind;

/// Lines of a colour and a width that lead from one place to another, in values.
std::vector<ReadLine> lines_of(const Drawing& drawing, const std::string& colour, double width) {
  std::vector<ReadLine> lines;
  for (ReadLine line : drawing.lines) {
    if (line.colour != colour || line.width != width) continue;
    for (auto& spot : line.path) spot = {drawing.x.value(spot.x), drawing.y.value(spot.y)};
    lines.push_back(line);
  }
  return lines;
}

TEST(ReadBackFigures, PointsOfEveryLawStandWhereTheyWereMeasured) {
  const StudyResult study = distinct::laws();
  const Drawing drawing = drawing_of(study);
  EXPECT_EQ(drawing.x.label, "abscissa of laws");
  EXPECT_EQ(drawing.y.label, "ordinate of laws");
  EXPECT_TRUE(drawing.x.is_log());
  EXPECT_TRUE(drawing.y.is_log());
  EXPECT_EQ(drawing.key.size(), study.series.size());
  for (const Series& s : study.series) {
    SCOPED_TRACE(s.name);
    const auto marks = drawing.marks_of(drawing.look_of(s.name));
    ASSERT_EQ(marks.size(), s.points.size());
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const records::Point& p = s.points[i];
      expect_near(drawing.x.value(marks[i].at.x), p.x);
      if (p.status == records::Status::unstable) {
        EXPECT_EQ(marks[i].kind, Kind::cross);
        EXPECT_LT(std::abs(marks[i].at.y - drawing.band), drawing.band - drawing.top) << "in the band";
        continue;
      }
      expect_near(drawing.y.value(marks[i].at.y), p.y.at("l2"));
      const bool fits = s.orders.empty() || (p.x >= s.orders[0].from && p.x <= s.orders[0].to);
      EXPECT_EQ(marks[i].kind, fits ? Kind::filled : Kind::hollow) << p.x;
    }
  }
}

TEST(ReadBackFigures, FitsAndFloorsHaveTheirSeriesColour) {
  const StudyResult study = distinct::laws();
  const Drawing drawing = drawing_of(study);
  EXPECT_EQ(drawing.key[0].text, "law 0   1.07 ± 0.03");
  EXPECT_EQ(drawing.key[1].text, "law 1   2.13 ± 0.05");
  EXPECT_EQ(drawing.key[2].text, "law 2");
  for (const std::size_t k : {0u, 1u}) {
    SCOPED_TRACE(k);
    const fits::ObservedOrder& o = study.series[k].orders[0];
    const auto fits = lines_of(drawing, drawing.key[k].look.colour, 2);
    ASSERT_EQ(fits.size(), 1u);
    for (const auto& [spot, x] : {std::pair{fits[0].path.front(), o.from}, std::pair{fits[0].path.back(), o.to}}) {
      expect_near(spot.x, x);
      expect_near(spot.y, o.constant * std::pow(x, -o.order));
    }
  }
  EXPECT_TRUE(lines_of(drawing, drawing.key[2].look.colour, 2).empty());
  const auto floors = lines_of(drawing, drawing.key[1].look.colour, 1.4);
  ASSERT_EQ(floors.size(), 1u);
  for (const auto& spot : floors[0].path) expect_near(spot.y, study.series[1].orders[0].floor->floor);
}

/// Whether a line of this colour leads from mark to mark.
bool joins(const Drawing& drawing, const std::string& colour, const std::vector<ReadMark>& marks) {
  return std::ranges::any_of(drawing.lines, [&](const ReadLine& line) {
    return line.colour == colour &&
           std::ranges::equal(line.path, marks, [](const read_back::Spot& spot, const ReadMark& mark) {
             return std::hypot(spot.x - mark.at.x, spot.y - mark.at.y) < 0.1;
           });
  });
}

TEST(ReadBackFigures, LongCurvesLeadThroughTheirPoints) {
  const StudyResult study = distinct::curves();
  const Drawing drawing = drawing_of(study);
  EXPECT_TRUE(drawing.marks.empty());
  for (const Series& s : study.series) {
    SCOPED_TRACE(s.name);
    const auto lines = lines_of(drawing, drawing.look_of(s.name).colour, 1.8);
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(lines[0].path.size(), s.points.size());
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      EXPECT_NEAR(lines[0].path[i].x, s.points[i].x, close);
      EXPECT_NEAR(lines[0].path[i].y, s.points[i].y.at("slope"), close);
    }
  }
}

TEST(ReadBackFigures, ReferenceTriangleRisesByItsOrderAndRunsByOne) {
  const Drawing drawing = drawing_of(distinct::laws());
  const auto dashed = lines_of(drawing, "rgb(128,128,128)", 1.2), triangles = lines_of(drawing, "rgb(96,96,96)", 1);
  ASSERT_EQ(dashed.size(), 1u);
  ASSERT_EQ(triangles.size(), 1u);
  const auto &a = dashed[0].path.front(), &b = dashed[0].path.back();
  EXPECT_NEAR(std::log(b.y / a.y) / std::log(b.x / a.x), -2, 0.01);
  std::map<std::string, read_back::Spot> labels;
  for (const auto& label : drawing.labels)
    labels[label.text] = {drawing.x.value(label.at.x), drawing.y.value(label.at.y)};
  ASSERT_EQ(labels.size(), 3u);
  EXPECT_TRUE(labels.contains("h^2"));
  const auto& t = triangles[0].path;
  ASSERT_EQ(t.size(), 3u);
  expect_near(t[0].x, t[1].x), expect_near(t[1].y, t[2].y);
  EXPECT_TRUE(labels.at("2").y < t[0].y && labels.at("2").y > t[1].y && labels.at("2").x < t[1].x) << "beside the rise";
  EXPECT_TRUE(labels.at("1").x > t[1].x && labels.at("1").x < t[2].x && labels.at("1").y < t[1].y) << "below the run";
}

TEST(ReadBackFigures, LimitsStandAtBothEndsOfTheirBrackets) {
  const StudyResult study = distinct::brackets();
  const Drawing drawing = drawing_of(study);
  EXPECT_FALSE(drawing.x.is_log());
  EXPECT_FALSE(drawing.y.is_log());
  EXPECT_EQ(drawing.key.at(0).text, "below   stable to 0.61");
  EXPECT_EQ(drawing.key.at(1).text, "above   stable from 0.43");
  for (const std::size_t k : {0u, 1u}) {
    SCOPED_TRACE(k);
    const Series& s = study.series[k];
    const auto lines = lines_of(drawing, drawing.key[k].look.colour, 1);
    std::vector<double> ends;
    for (const ReadLine& line : lines)
      if (std::abs(line.path.front().x - line.path.back().x) < 1e-9) ends.push_back(line.path.front().x);
    ASSERT_EQ(ends.size(), 2u);
    expect_near(ends[0], s.limit->stable);
    expect_near(ends[1], s.limit->unstable);
    const auto marks = drawing.marks_of(drawing.key[k].look);
    ASSERT_EQ(marks.size(), s.points.size());
    for (std::size_t i = 0; i < marks.size(); ++i) {
      expect_near(drawing.x.value(marks[i].at.x), s.points[i].x);
      expect_near(drawing.y.value(marks[i].at.y), s.points[i].y.at("l2"));
    }
  }
}

/// What a row of a stability map shows.
struct MapRow {
  std::vector<double> stable, unstable;
  double from = 0, to = 0;  ///< of its frame
  std::string limit;        ///< on the right
};

std::map<std::string, MapRow> rows_of(const Drawing& drawing) {
  std::map<std::string, MapRow> rows;
  const auto row = [&](double y) -> MapRow& { return rows[drawing.y.name(y)]; };
  for (const ReadMark& mark : drawing.marks_of(drawing.look_of("stable")))
    row(mark.at.y).stable.push_back(drawing.x.value(mark.at.x));
  for (const ReadMark& mark : drawing.marks_of(drawing.look_of("unstable")))
    row(mark.at.y).unstable.push_back(drawing.x.value(mark.at.x));
  for (const ReadLine& line : drawing.lines) {
    if (line.colour != "rgb(0,0,0)" || line.width != 3) continue;
    const auto [low, high] = std::ranges::minmax(line.path, {}, &read_back::Spot::y);
    const auto [left, right] = std::ranges::minmax(line.path, {}, &read_back::Spot::x);
    MapRow& framed = row((low.y + high.y) / 2);
    framed.from = drawing.x.value(left.x), framed.to = drawing.x.value(right.x);
  }
  for (const auto& label : drawing.labels) row(label.at.y).limit = label.text;
  return rows;
}

TEST(ReadBackFigures, EveryRowOfAStabilityMapIsThatOfItsSeries) {
  const StudyResult study = distinct::limits();
  const Drawing drawing = drawing_of(study);
  EXPECT_EQ(drawing.x.label, "abscissa of limits");
  EXPECT_TRUE(drawing.x.is_log());
  auto rows = rows_of(drawing);
  EXPECT_EQ(rows.size(), study.series.size());
  for (const Series& s : study.series) {
    SCOPED_TRACE(s.name);
    const fits::StabilityLimit& limit = *s.limit;
    const MapRow& row = rows[s.name];
    ASSERT_EQ(row.stable.size(), 2u);
    ASSERT_EQ(row.unstable.size(), 2u);
    for (const std::size_t i : {0u, 1u}) {
      expect_near(row.stable[i], limit.probes[i].value);
      expect_near(row.unstable[i], limit.probes[i + 2].value);
    }
    expect_near(row.from, limit.found ? limit.stable : 0);
    expect_near(row.to, limit.found ? limit.unstable : 0);
    const std::string ends = fmt::format("{:#.3g} to {:#.3g}", limit.stable, limit.unstable),
                      middle = fmt::format("{:#.3g}", limit.value());
    EXPECT_EQ(row.limit, (!limit.found     ? "not found"
                          : limit.monotone ? middle
                                           : ends) +
                             (limit.monotone ? "" : ", not monotone"));
  }
}

TEST(ReadBackFigures, ErrorsStandAboveTheirCosts) {
  const StudyResult study = distinct::costs();
  const Drawing drawing = drawing_of(study);
  EXPECT_EQ(drawing.x.label, "abscissa of costs");
  EXPECT_EQ(drawing.y.label, "ordinate of costs");
  EXPECT_TRUE(drawing.x.is_log());
  EXPECT_FALSE(drawing.y.is_log());
  std::set<Look> looks;
  for (const Series& s : study.series) {
    SCOPED_TRACE(s.name);
    const Look look = drawing.look_of(s.name);
    looks.insert(look);
    const auto marks = drawing.marks_of(look);
    EXPECT_TRUE(joins(drawing, look.colour, marks));
    ASSERT_EQ(marks.size(), s.points.size());
    for (std::size_t i = 0; i < marks.size(); ++i) {
      expect_near(drawing.x.value(marks[i].at.x), s.points[i].y.at("step_seconds"));
      expect_near(drawing.y.value(marks[i].at.y), s.points[i].y.at("l2"));
    }
  }
  std::vector<double> rings;
  for (const ReadMark& mark : drawing.marks)
    if (!looks.contains(mark.look)) rings.push_back(drawing.x.value(mark.at.x));
  const std::vector<double> front{1.3, 11, 14, 97};
  ASSERT_EQ(rings.size(), front.size());
  for (std::size_t i = 0; i < front.size(); ++i) expect_near(rings[i], front[i]);
}

}  // namespace mpmvv::reports::read_back_figures_test
