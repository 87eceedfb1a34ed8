#include "reports/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "studies/support/error.hpp"
#include "tests/reports/synthetic.hpp"

namespace mpmvv::reports {
namespace chart_test {

using records::Series;
using records::Status;
using records::StudyResult;

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Rule> rules(const Chart& chart, Rule::Kind kind) {
  std::vector<Rule> result;
  std::ranges::copy_if(chart.rules, std::back_inserter(result), [&](const Rule& r) { return r.kind == kind; });
  return result;
}

Chart convergence_chart() {
  const auto study = synthetic::convergence();
  return error_chart(study, study.figures[0]);
}

/// Only the second-order series, whose fit is exact.
Chart plain_chart(std::vector<double> slopes) {
  auto study = synthetic::convergence();
  study.figures[0].series = {"bspline2, 4 PPC"};
  study.figures[0].slopes = std::move(slopes);
  return error_chart(study, study.figures[0]);
}

TEST(ErrorChart, FitIsDrawnOverItsWindowOnly) {
  const auto fits = rules(plain_chart({}), Rule::Kind::fit);
  ASSERT_EQ(fits.size(), 1u);
  EXPECT_EQ(fits[0].path.front().x, 16);
  EXPECT_EQ(fits[0].path.back().x, 128);
  EXPECT_NEAR(fits[0].path.front().y, 0.3 * std::pow(16, -2.01), 1e-15);
  EXPECT_NEAR(fits[0].path.back().y, 0.3 * std::pow(128, -2.01), 1e-15);
}

TEST(ErrorChart, PointsOutsideTheWindowAreMarked) {
  const auto chart = plain_chart({});
  std::vector<Mark> marks;
  for (const auto& dot : chart.curves[0].dots) marks.push_back(dot.mark);
  EXPECT_THAT(marks, ElementsAre(Mark::outside, Mark::inside, Mark::inside, Mark::inside, Mark::inside, Mark::outside,
                                 Mark::outside));
}

TEST(ErrorChart, UnstablePointsHangFromTheUpperEdgeOneBelowTheOther) {
  const auto chart = convergence_chart();
  const Dot& first = chart.curves[3].dots[0];
  const Dot& second = chart.curves[4].dots[0];
  ASSERT_EQ(first.mark, Mark::unstable);
  ASSERT_EQ(second.mark, Mark::unstable);
  EXPECT_EQ(first.x, second.x);
  EXPECT_GT(chart.y.fraction(first.drawn), 0.95);
  EXPECT_LT(chart.y.fraction(first.drawn), 1);
  EXPECT_LT(second.drawn, first.drawn);
}

TEST(ErrorChart, KeyHasOrderAndInterval) {
  EXPECT_THAT(convergence_chart().curves[1].key, HasSubstr("bspline2, 4 PPC   2.01 ± 0.03"));
}

TEST(ErrorChart, KeyHasNoIntervalWithoutOne) {
  auto study = synthetic::convergence();
  study.series[1].orders[0].half_width = support::not_measured;
  EXPECT_THAT(error_chart(study, study.figures[0]).curves[1].key, testing::EndsWith("2.01"));
  study.series[1].orders[0].order = support::not_measured;
  EXPECT_EQ(error_chart(study, study.figures[0]).curves[1].key, "bspline2, 4 PPC");
}

TEST(ErrorChart, EveryWindowOfANormHasItsFit) {
  auto study = synthetic::convergence();
  study.figures[0].series = {"bspline2, 4 PPC"};
  auto second = study.series[1].orders[0];
  second.from = 256, second.to = 512, second.order = 1.5;
  study.series[1].orders.push_back(second);
  const auto chart = error_chart(study, study.figures[0]);
  EXPECT_EQ(rules(chart, Rule::Kind::fit).size(), 2u);
  EXPECT_THAT(chart.curves[0].key, HasSubstr("2.01 ± 0.03, 1.50 ± 0.03"));
  EXPECT_EQ(chart.curves[0].dots[5].mark, Mark::inside);
}

TEST(ErrorChart, OnlyAnAcceptedFloorIsDrawn) {
  auto study = synthetic::convergence();
  const auto floors = rules(error_chart(study, study.figures[0]), Rule::Kind::floor);
  ASSERT_EQ(floors.size(), 2u);
  EXPECT_EQ(floors[1].path[0].y, 1.1e-6);
  EXPECT_EQ(floors[1].path[1].y, 1.1e-6);
  study.series[0].orders[0].floor->accepted = false;
  EXPECT_EQ(rules(error_chart(study, study.figures[0]), Rule::Kind::floor).size(), 1u);
}

TEST(ErrorChart, ReferenceSlopeAndTriangleHaveTheSlope) {
  const auto chart = plain_chart({2});
  const auto lines = rules(chart, Rule::Kind::reference);
  const auto triangles = rules(chart, Rule::Kind::triangle);
  ASSERT_EQ(lines.size(), 1u);
  ASSERT_EQ(triangles.size(), 1u);
  const auto slope = [](const Place& a, const Place& b) { return std::log(b.y / a.y) / std::log(b.x / a.x); };
  EXPECT_NEAR(slope(lines[0].path[0], lines[0].path[1]), -2, 1e-9) << "cells is 1/h";
  const auto& t = triangles[0].path;
  EXPECT_NEAR(std::log(t[0].y / t[1].y) / std::log(t[2].x / t[1].x), 2, 1e-9);
  EXPECT_NEAR(t[0].x, t[1].x, 1e-9 * t[0].x);
  EXPECT_NEAR(t[1].y, t[2].y, 1e-9 * t[1].y);
  EXPECT_EQ(chart.labels[0].text, "{/:Italic h}^{2}");
}

TEST(ErrorChart, ReferenceSlopeRisesWithStepSize) {
  auto study = synthetic::convergence();
  study.sweep = "h";
  for (auto& s : study.series)
    for (auto& p : s.points) p.x = 1 / p.x;
  study.figures[0].slopes = {1};
  const auto line = rules(error_chart(study, study.figures[0]), Rule::Kind::reference);
  ASSERT_EQ(line.size(), 1u);
  const auto& [a, b] = std::pair{line[0].path[0], line[0].path[1]};
  EXPECT_NEAR(std::log(b.y / a.y) / std::log(b.x / a.x), 1, 1e-9);
}

TEST(ErrorChart, ReferenceSlopeKeepsClearOfThePoints) {
  const auto chart = plain_chart({2});
  const auto line = rules(chart, Rule::Kind::reference)[0].path;
  for (const auto& dot : chart.curves[0].dots) {
    const double t = (chart.x.fraction(dot.x) - chart.x.fraction(line[0].x)) /
                     (chart.x.fraction(line[1].x) - chart.x.fraction(line[0].x));
    if (t < 0 || t > 1) continue;
    const double on_line =
        chart.y.fraction(line[0].y) + t * (chart.y.fraction(line[1].y) - chart.y.fraction(line[0].y));
    EXPECT_GT(std::abs(chart.y.fraction(dot.drawn) - on_line), 0.03);
  }
}

TEST(ErrorChart, LimitOfTheSweptKeyIsBracketed) {
  auto study = synthetic::convergence();
  study.sweep = "cfl";
  fits::StabilityLimit limit;
  limit.key = "cfl", limit.stable = 60, limit.unstable = 61, limit.found = true;
  study.series[1].limit = limit;
  const auto brackets = rules(error_chart(study, study.figures[0]), Rule::Kind::limit);
  ASSERT_EQ(brackets.size(), 2u);
  EXPECT_EQ(brackets[0].path[0].x, 60);
  EXPECT_EQ(brackets[1].path[1].x, 61);
  study.series[1].limit->key = "smoothing_length";
  EXPECT_TRUE(rules(error_chart(study, study.figures[0]), Rule::Kind::limit).empty());
}

TEST(ErrorChart, SaysWhatItCouldNotDraw) {
  auto study = synthetic::convergence();
  auto& points = study.series[1].points;
  points[0].status = Status::failed;
  points[1].y["l2"] = support::not_measured;
  points[2].y["l2"] = 0;
  study.figures[0].series = {"bspline2, 4 PPC"};
  const auto chart = error_chart(study, study.figures[0]);
  EXPECT_EQ(
      chart.notes.back(),
      "Without a point: bspline2, 4 PPC at 8 (failed); bspline2, 4 PPC at 16 (not measured); bspline2, 4 PPC at 32 "
      "(0).");
  EXPECT_EQ(chart.curves[0].dots[2].mark, Mark::absent);
}

TEST(ErrorChart, SaysWhatADeclaredRangeCutsOff) {
  auto study = synthetic::convergence();
  study.figures[0].series = {"bspline2, 4 PPC"};
  study.figures[0].y_max = 1e-3;
  EXPECT_EQ(
      error_chart(study, study.figures[0]).notes.back(),
      "Without a point: bspline2, 4 PPC at 8 (0.004591 is off the axes); bspline2, 4 PPC at 16 (0.00114 is off the "
      "axes).");
}

TEST(ErrorChart, LongCurvesHaveNoMarkers) {
  const auto study = synthetic::check();
  const auto chart = error_chart(study, study.figures[0]);
  EXPECT_FALSE(chart.curves[0].marked);
  EXPECT_TRUE(chart.curves[0].emphasised);
  EXPECT_FALSE(chart.x.log);
  EXPECT_TRUE(convergence_chart().curves[0].marked);
  EXPECT_FALSE(convergence_chart().curves[0].emphasised);
}

TEST(ErrorChart, UnknownSeriesIsNamed) {
  auto study = synthetic::check();
  study.figures[0].series = {"N", "M"};
  try {
    error_chart(study, study.figures[0]);
    FAIL();
  } catch (const support::UsageError& e) {
    EXPECT_STREQ(e.what(),
                 "figure 's-fig4' of study 'weights' names the series 'M', which the study lacks (it has: N, dN/dx)");
  }
}

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
  figure.name = "x-cost", figure.kind = "work-precision", figure.xlabel = "s", figure.ylabel = "error";
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
  EXPECT_THAT(charts[0].notes, testing::Contains(HasSubstr("1 of slow")));
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
  study.kind = "check";
  study.series = {Series{"t = 0", {}, {}, {}}, Series{"t = 1", {}, {}, {}}};
  for (auto& series : study.series)
    for (const double y : {0.5, 1.5})
      series.points.push_back({0.5, Status::ok, "", {{"y", y}, {"width_x", 1}, {"width_y", 1}}});
  records::Figure figure;
  figure.name = "particles", figure.kind = "particles", figure.xlabel = "x", figure.ylabel = "y";
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
  EXPECT_EQ(map.labels[2].text, "0.880, not monotone");
  EXPECT_EQ(map.labels[7].text, "not found");
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

}  // namespace chart_test
}  // namespace mpmvv::reports
