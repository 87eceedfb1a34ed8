#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/chart.hpp"
#include "reports/picture.hpp"
#include "reports/plot.hpp"
#include "studies/support/error.hpp"
#include "tests/reports/rules.hpp"
#include "tests/reports/synthetic.hpp"

/// Charts of other kinds than errors.
namespace mpmvv::reports::chart_kinds_test {

using records::Series;
using records::Status;
using records::StudyResult;

using testing::ElementsAre;
using testing::HasSubstr;

/// Costs grow as cells², errors of the two series fall as cells⁻¹ and cells⁻²: they cross between 1 and 4 s.
StudyResult work_study() {
  StudyResult study;
  study.name = "x-cost";
  study.sweep = "cells";
  study.series = {Series{"slow", {}, {}, {}}, Series{"fast", {}, {}, {}}};
  for (const double n : {1.0, 2.0, 4.0, 8.0}) {
    study.series[0].points.push_back({n, Status::ok, "", {{"l2", 0.3 / n}, {"step_seconds", n * n}}});
    study.series[1].points.push_back({n, Status::ok, "", {{"l2", 0.5 / (n * n)}, {"step_seconds", n * n}}});
  }
  study.series[0].points[3] = {8, Status::unstable, "blown up", {}};
  records::Figure figure;
  figure.name = "x-cost", figure.kind = records::Figure::Kind::work_precision, figure.xlabel = "s",
  figure.ylabel = "error";
  study.figures = {figure};
  return study;
}

TEST(WorkChart, DrawsErrorAgainstCostAndTheFrontOfAllSeries) {
  const auto charts = charts_of(work_study());
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].curves[1].dots[3].x, 64);
  EXPECT_EQ(charts[0].curves[1].dots[3].value, 0.5 / 64);
  const auto fronts = rules(charts[0], Rule::Kind::front);
  ASSERT_EQ(fronts.size(), 1u);
  std::vector<double> errors;
  for (const Place& p : fronts[0].path) errors.push_back(p.y);
  EXPECT_THAT(errors, ElementsAre(0.3, 0.5 / 4, 0.5 / 16, 0.5 / 64));
  EXPECT_THAT(charts[0].omissions,
              ElementsAre("Without a point, as they are unstable, failed or were not measured: 1 of slow."));
}

TEST(WorkChart, TheRangeOfRepeatedTimesIsABarWhereItIsSeen) {
  auto study = work_study();
  auto& points = study.series[1].points;
  points[0].rounds = {{50, 50, 400}, "a session"};  // their geometric mean is 100, the run's cost 1
  points[1].rounds = {{99, 100, 101}, "a session"};
  const Chart chart = charts_of(study).at(0);
  const auto& dots = chart.curves[1].dots;
  EXPECT_DOUBLE_EQ(dots[0].least_x, 0.5);
  EXPECT_DOUBLE_EQ(dots[0].most_x, 4);
  EXPECT_FALSE(has_range(dots[1])) << "hidden by its point";
  EXPECT_FALSE(has_range(dots[2])) << "a store without rounds";
  EXPECT_LE(chart.x.from, dots[0].least_x);
  EXPECT_THAT(chart.notes, testing::Contains(HasSubstr("Bars: from the smallest to the largest of the repeated")));
  const Plot plot = plot_of(chart);
  EXPECT_THAT(plot.script, HasSubstr("data index 1 using 1:3:5:6 with xerrorbars"));
  EXPECT_THAT(plot.data, testing::ContainsRegex("\n1 0.5 0.5 1 0.5[0-9]* [34][.0-9]*\n4 0.125 0.125 1 NaN NaN\n"));
  EXPECT_THAT(charts_of(work_study()).at(0).notes, testing::Not(testing::Contains(HasSubstr("Bars"))));
}

TEST(WorkChart, WithoutAnyCostIsStillDrawn) {
  auto study = work_study();
  for (auto& series : study.series)
    for (auto& point : series.points) point.y.erase("step_seconds");
  EXPECT_TRUE(rules(work_chart(study, study.figures[0]), Rule::Kind::front).empty());
}

/// Two panels of two particles, 1 wide and 2 high.
StudyResult particle_study() {
  StudyResult study;
  study.name = "particles";
  study.kind = records::StudyKind::check;
  study.series = {Series{"t = 0", {}, {}, {}}, Series{"t = 1", {}, {}, {}}};
  for (auto& series : study.series)
    for (const double y : {0.5, 1.5})
      series.points.push_back({0.5, Status::ok, "", {{"y", y}, {"width_x", 1}, {"width_y", 1}}});
  records::Figure figure;
  figure.name = "particles", figure.kind = records::Figure::Kind::particles, figure.xlabel = "x", figure.ylabel = "y";
  study.figures = {figure};
  return study;
}

TEST(ParticleChart, PanelsStandSideBySideWithTheirOwnTics) {
  const auto study = particle_study();
  const auto chart = charts_of(study).at(0);
  EXPECT_TRUE(chart.to_scale);
  ASSERT_EQ(chart.boxes.size(), 4u);
  const double pitch = chart.boxes[2].centre.x - chart.boxes[0].centre.x;
  EXPECT_GT(pitch, 1) << "panels do not touch";
  EXPECT_EQ(chart.boxes[0].width_x, 1);
  EXPECT_EQ(chart.curves[1].dots[0].x, chart.boxes[2].centre.x);
  const auto frames = rules(chart, Rule::Kind::frame);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].path[2].y - frames[0].path[0].y, 2) << "the frame holds whole voxels";
  EXPECT_NEAR(frames[1].path[0].x - frames[0].path[0].x, pitch, 1e-15);
  for (const Tic& tic : chart.x.tics)
    if (tic.at > 1.06 && !tic.text.empty()) {
      EXPECT_NEAR(std::stod(tic.text), tic.at - pitch, 1e-12);
    }
  EXPECT_EQ(chart.labels[1].text, "t = 1");
}

TEST(ParticleChart, ParticlesWithoutWidthsAreDots) {
  auto study = particle_study();
  for (auto& series : study.series)
    for (auto& point : series.points) point.y.erase("width_x");
  const auto chart = particle_chart(study, study.figures[0]);
  EXPECT_TRUE(chart.boxes.empty());
  EXPECT_EQ(chart.curves[0].dots.size(), 2u);
  study.series.clear();
  EXPECT_TRUE(particle_chart(study, study.figures[0]).curves.empty());
}

TEST(StabilityMap, HasEveryProbeAndEveryLimit) {
  const auto study = synthetic::limits();
  const auto charts = charts_of(study);
  ASSERT_EQ(charts.size(), 1u);
  const auto& map = charts[0];
  EXPECT_EQ(map.name, "bar-cfl-map");
  std::size_t probes = 0;
  for (const auto& s : study.series) probes += s.limit->probes.size();
  EXPECT_EQ(map.curves[0].dots.size() + map.curves[1].dots.size(), probes);
  EXPECT_TRUE(std::ranges::all_of(map.curves[1].dots, [](const Dot& d) { return d.mark == Mark::unstable; }));
  EXPECT_EQ(rules(map, Rule::Kind::limit).size(), 7u) << "the eighth was not found";
  EXPECT_EQ(map.y.tics[0].text, "l = 1h/8, 4 PPC");
  EXPECT_GT(map.y.tics[0].at, map.y.tics[1].at) << "first series on top";
  EXPECT_EQ(map.labels[0].text, "0.760");
  EXPECT_EQ(map.labels[2].text, "0.876 to 0.884, not monotone");
  EXPECT_EQ(map.labels[7].text, "not found");
}

TEST(StabilityMap, IsDescribedRowByRow) {
  const std::string text = description_of(charts_of(synthetic::limits()).at(0));
  EXPECT_THAT(text, testing::StartsWith("Stable and unstable runs of each series against CFL number"));
  EXPECT_THAT(text, HasSubstr(" l = 1h/8, 4 PPC: limit 0.760, stable at 10 of 19 values."));
  EXPECT_THAT(text, HasSubstr(" l = 3h/8, 4 PPC: limit 0.876 to 0.884, not monotone, stable at 12 of 19 values."));
  EXPECT_THAT(text, testing::EndsWith(" l = 8h/8, 4 PPC: limit not found, stable at 15 of 19 values."));
}

TEST(StabilityMap, DeclaredFigureWithoutValuesIsTheMap) {
  auto study = synthetic::limits();
  records::Figure figure;
  figure.name = "s-fig9", figure.xlabel = "CFL number", figure.series = {"l = 2h/8, 4 PPC"};
  study.figures = {figure};
  const auto charts = charts_of(study);
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_EQ(charts[0].name, "s-fig9");
  EXPECT_EQ(charts[0].x.label, "CFL number");
  EXPECT_EQ(charts[0].y.tics.size(), 1u);
}

}  // namespace mpmvv::reports::chart_kinds_test
