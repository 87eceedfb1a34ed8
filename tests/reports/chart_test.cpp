#include "reports/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reports/orders_table.hpp"
#include "reports/table.hpp"
#include "reports/unstable_band.hpp"
#include "studies/support/error.hpp"
#include "tests/reports/rules.hpp"
#include "tests/reports/synthetic.hpp"

namespace mpmvv::reports::chart_test {

using records::Series;
using records::Status;

using testing::ElementsAre;
using testing::HasSubstr;

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

TEST(ErrorChart, UnstablePointsHaveABandAboveAllValuesOneBelowTheOther) {
  const auto chart = convergence_chart();
  const Dot& first = chart.curves[3].dots[0];
  const Dot& second = chart.curves[4].dots[0];
  ASSERT_EQ(first.mark, Mark::unstable);
  ASSERT_EQ(second.mark, Mark::unstable);
  EXPECT_EQ(first.x, second.x);
  EXPECT_LT(second.drawn, first.drawn);
  EXPECT_GT(chart.y.fraction(second.drawn), 1 - chart.band);
  EXPECT_LT(chart.y.fraction(first.drawn), 1);
  for (const Curve& curve : chart.curves)
    for (const Dot& dot : curve.dots) {
      EXPECT_TRUE(holds(chart, dot) || dot.mark == Mark::absent) << curve.name << dot.x;
      if (dot.mark != Mark::unstable && dot.mark != Mark::absent) {
        EXPECT_LT(dot.drawn, top_of_values(chart));
      }
    }
  ASSERT_EQ(chart.y.tics.back().text, "unstable");
  EXPECT_FALSE(std::ranges::any_of(chart.y.tics, [&](const Tic& tic) {
    const double way = 1 - chart.band / 2 - chart.y.fraction(tic.at);
    return !tic.text.empty() && way > 1e-9 && way < 1.15 * chart.letter;
  })) << "its name touches no other";
  EXPECT_NEAR(chart.y.fraction(chart.y.tics.back().at), 1 - chart.band / 2, 1e-12);
  EXPECT_THAT(chart.notes.at(0), HasSubstr("Crosses in the band at the upper edge: unstable."));
  EXPECT_EQ(plain_chart({}).band, 0) << "without an unstable run";
}

/// Names of a power of two digits are wider than high.
TEST(ErrorChart, NamesOfReferenceSlopesDoNotTouch) {
  const auto chart = plain_chart({2, 1.5, 0.5});
  std::vector<Place> names;
  for (const Label& label : chart.labels)
    if (label.formula) names.push_back({chart.x.fraction(label.at.x), chart.y.fraction(label.at.y)});
  ASSERT_EQ(names.size(), 3u);
  const double half = 0.37 * chart.letter * 4 / 2;
  for (std::size_t a = 0; a < names.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_TRUE(std::abs(names[a].x - names[b].x) > 2 * half || std::abs(names[a].y - names[b].y) > chart.letter)
          << a << " and " << b;
}

TEST(ErrorChart, KeyHasOrderAndInterval) {
  EXPECT_THAT(convergence_chart().curves[1].key, HasSubstr("bspline2, 4 PPC   2.01 ± 0.03"));
}

/// As criteria have it, and the other tables.
TEST(ErrorChart, KeyHasTheIntervalOfReplicates) {
  auto study = synthetic::convergence();
  fits::ObservedOrder& order = study.series[1].orders[0];
  order.replicates.emplace();
  order.replicates->half_width = 0.31;
  EXPECT_THAT(error_chart(study, study.figures[0]).curves[1].key, testing::EndsWith("2.01 ± 0.31"));
  EXPECT_EQ(fits_table(study).groups[1].rows[0][3], "2.01 ± 0.31");
  EXPECT_EQ(orders_table({&study}).groups[0].rows[1][4], "2.01 ± 0.31");
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

/// An order over cfl is fitted to the Courant numbers of the runs, and its line has to pass by their errors.
TEST(ErrorChart, TheFitOverCourantNumbersPassesByTheErrors) {
  auto study = synthetic::convergence();
  study.sweep = "cfl";
  study.figures[0].series = {"bspline2, 4 PPC"};
  records::Series& series = study.series[1];
  fits::ObservedOrder& order = series.orders[0];
  order.order = 1, order.constant = 3;
  for (records::Point& point : series.points) {
    point.y["cfl"] = 0.9 * point.x;
    point.y[study.figures[0].quantity] = 3 * point.y["cfl"];
  }
  const auto fits = rules(error_chart(study, study.figures[0]), Rule::Kind::fit);
  ASSERT_EQ(fits.size(), 1u);
  for (const Place& place : {fits[0].path.front(), fits[0].path.back()})
    EXPECT_NEAR(place.y, 3 * 0.9 * place.x, 1e-12 * place.y);
}

/// Any two points lie on a line, unless they are all that the window has.
TEST(ErrorChart, AnOrderOfTwoPointsLeftOverIsNotDrawn) {
  auto study = synthetic::convergence();
  study.figures[0].series = {"bspline2, 4 PPC"};
  study.series[1].orders[0].points = 2;
  const auto chart = error_chart(study, study.figures[0]);
  EXPECT_TRUE(rules(chart, Rule::Kind::fit).empty());
  EXPECT_EQ(chart.curves[0].key, "bspline2, 4 PPC");
  study.series[1].orders[0].to = 32;
  EXPECT_EQ(rules(error_chart(study, study.figures[0]), Rule::Kind::fit).size(), 1u);
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
  EXPECT_EQ(chart.labels[0].text, "h^2");
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
  EXPECT_EQ(error_chart(study, study.figures[0]).labels[0].text, "slope 1") << "h may be another length here";
}

TEST(ErrorChart, ReferenceSlopeOverParticlesPerCellIsNamedAfterThem) {
  auto study = synthetic::convergence();
  study.sweep = "ppc";
  study.figures[0].slopes = {2};
  EXPECT_EQ(error_chart(study, study.figures[0]).labels[0].text, "ppc^-2") << "h stays as it is";
  study.figures[0].slopes = {-1};
  EXPECT_EQ(error_chart(study, study.figures[0]).labels[0].text, "ppc");
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
      chart.omissions.back(),
      "Without a point: bspline2, 4 PPC at 8 (failed); bspline2, 4 PPC at 16 (not measured); bspline2, 4 PPC at 32 "
      "(0).");
  EXPECT_EQ(chart.curves[0].dots[2].mark, Mark::absent);
}

TEST(ErrorChart, SaysARunOfPointsThatItCouldNotDrawAsOne) {
  auto study = synthetic::convergence();
  auto& points = study.series[1].points;
  for (const std::size_t k : {0u, 1u, 2u, 4u}) points[k].y["l2"] = support::not_measured;
  study.figures[0].series = {"bspline2, 4 PPC"};
  EXPECT_EQ(error_chart(study, study.figures[0]).omissions.back(),
            "Without a point: bspline2, 4 PPC from 8 to 32 (not measured); bspline2, 4 PPC at 128 (not measured).");
}

TEST(ErrorChart, SaysWhatADeclaredRangeCutsOff) {
  auto study = synthetic::convergence();
  study.figures[0].series = {"bspline2, 4 PPC"};
  study.figures[0].y_max = 1e-3;
  EXPECT_EQ(
      error_chart(study, study.figures[0]).omissions.back(),
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

}  // namespace mpmvv::reports::chart_test
