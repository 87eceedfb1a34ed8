#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/reports/distinct.hpp"
#include "tests/reports/read_back_drawing.hpp"

/// What stands where in the panels of particles and in the figures of trends.
namespace mpmvv::reports::read_back_panels_test {

using claims::Finding;
using records::StudyResult;

using read_back::Drawing;
using read_back::drawing_of;
using read_back::expect_near;
using read_back::ReadAxis;
using read_back::ReadMark;
using read_back::WrittenReport;
using Kind = ReadMark::Kind;

/// The axes of panels side by side: their numbers begin anew with each.
std::vector<ReadAxis> panel_axes(const ReadAxis& axis) {
  std::vector<ReadAxis> panels;
  double last = INFINITY;
  for (const auto& tic : axis.tics) {
    const double number = std::stod(tic.text);
    if (number < last) panels.push_back({axis.label, {}});
    panels.back().tics.push_back(tic);
    last = number;
  }
  return panels;
}

TEST(ReadBackFigures, ParticlesAndVoxelsLieInTheirPanels) {
  const StudyResult study = distinct::particles();
  const Drawing drawing = drawing_of(study);
  EXPECT_EQ(drawing.x.label, "abscissa of particles");
  EXPECT_EQ(drawing.y.label, "ordinate of particles");
  const auto panels = panel_axes(drawing.x);
  ASSERT_EQ(panels.size(), study.series.size());
  ASSERT_EQ(drawing.labels.size(), study.series.size());
  std::vector<records::Point> all;
  std::vector<std::size_t> panel_of;
  for (std::size_t k = 0; k < study.series.size(); ++k)
    for (const records::Point& p : study.series[k].points) all.push_back(p), panel_of.push_back(k);
  ASSERT_EQ(drawing.marks.size(), all.size());
  ASSERT_EQ(drawing.boxes.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ReadAxis& x = panels[panel_of[i]];
    expect_near(x.value(drawing.marks[i].at.x), all[i].x);
    expect_near(drawing.y.value(drawing.marks[i].at.y), all[i].y.at("y"));
    const auto [left, right] = std::ranges::minmax(drawing.boxes[i].path, {}, &read_back::Spot::x);
    const auto [top, bottom] = std::ranges::minmax(drawing.boxes[i].path, {}, &read_back::Spot::y);
    const double shown = 0.88;
    EXPECT_NEAR(x.value(right.x) - x.value(left.x), shown * all[i].y.at("width_x"), 0.01);
    EXPECT_NEAR(drawing.y.value(top.y) - drawing.y.value(bottom.y), shown * all[i].y.at("width_y"), 0.01);
    EXPECT_NEAR(x.value((left.x + right.x) / 2), all[i].x, 0.01);
  }
  for (std::size_t k = 0; k < panels.size(); ++k) {
    EXPECT_EQ(drawing.labels[k].text, study.series[k].name);
    EXPECT_GT(drawing.labels[k].at.x, panels[k].tics.front().pixel);
    EXPECT_LT(drawing.labels[k].at.x, panels[k].tics.back().pixel);
  }
}

TEST(ReadBackFigures, TrendsStandAboveTheCommitsOfTheirVersions) {
  const std::vector<std::vector<double>> numbers{{1.3, 1.7, 2.2},          {2.6, 3.1, 1.1},    {0.8e-3, 2.6e-3, 1.9e-3},
                                                 {4.4e-3, 3.6e-3, 7.1e-3}, {0.34, 0.47, 0.61}, {0.86, 0.29, 0.72}};
  History history{"",
                  {{"d1a", {"first1"}, "2026-01-01"},
                   {"d2b", {"second", "later2"}, "2026-01-02"},
                   {"d3c", {"third3"}, "2026-01-03"}},
                  {}};
  const std::vector<std::pair<Finding::Kind, std::string>> kinds{{Finding::Kind::order, "observed order"},
                                                                 {Finding::Kind::error, "error"},
                                                                 {Finding::Kind::limit, "stability limit"}};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    history.trends.push_back({"s", kinds[i / 2].first, fmt::format("trend {}", i), numbers[i]});
  ReportInput input;
  input.histories = {history};
  const WrittenReport report(input);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    SCOPED_TRACE(history.trends[i].name);
    const Drawing drawing = report.drawing(kinds[i / 2].second);
    EXPECT_EQ(drawing.y.label, kinds[i / 2].second);
    EXPECT_EQ(drawing.x.label, "commit");
    EXPECT_EQ(drawing.y.is_log(), kinds[i / 2].first == Finding::Kind::error);
    const auto marks = drawing.marks_of(drawing.look_of(history.trends[i].name));
    ASSERT_EQ(marks.size(), numbers[i].size());
    for (std::size_t v = 0; v < marks.size(); ++v) {
      EXPECT_EQ(drawing.x.name(marks[v].at.x), history.versions[v].commits[0]);
      expect_near(drawing.y.value(marks[v].at.y), numbers[i][v]);
    }
  }
  read_back::ExpectedTable versions;
  versions.add("", {{"version", "3"}, {"first result", "2026-01-03"}, {"commits", "third3"}, {"digest", "d3c"}});
  versions.add("", {{"version", "2"}, {"first result", "2026-01-02"}, {"commits", "second later2"}, {"digest", "d2b"}});
  versions.add("", {{"version", "1"}, {"first result", "2026-01-01"}, {"commits", "first1"}, {"digest", "d1a"}});
  report.expect_html(versions);
}

}  // namespace mpmvv::reports::read_back_panels_test
