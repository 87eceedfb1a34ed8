#include "goldens/propose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "goldens/gate.hpp"
#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"
#include "tests/goldens/propose_samples.hpp"

namespace mpmvv::goldens::propose_test {

using namespace propose_samples;

using support::UsageError;

using testing::HasSubstr;

TEST(Propose, OrdersAndErrorsRoundTripWithTheBandsOfTheHouse) {
  const auto goldens = proposed(study_with(convergent()));
  ASSERT_EQ(goldens.size(), 2U);
  EXPECT_EQ(goldens[0].study, "s-fig10");
  const auto& order = std::get<OrderGolden>(goldens[0].expectation);
  EXPECT_EQ(order.series, convergent().name);
  EXPECT_EQ(order.expected, 2);
  EXPECT_EQ(order.lower, 1.85);
  EXPECT_EQ(order.upper, 2.15);
  const auto& error = std::get<ErrorGolden>(goldens[1].expectation);
  EXPECT_EQ(error.at, 64) << "the finest level that is stable and measured";
  EXPECT_EQ(error.norm, "l2");
  EXPECT_NEAR(error.expected, 1.00049e-4, 1e-7);
  EXPECT_EQ(error.band, 0.1);
}

/// The numbers of the order's own golden, whatever else the series has.
TEST(Propose, AnOrderTakesItsFinestLevelFromItsOwnWindow) {
  const auto of = [](const std::string& sweep, double from, double to) {
    Series series;
    series.name = "a";
    for (const double x : {8, 16, 32, 64, 128})
      series.points.push_back({x, Status::ok, "", {{"l2", x}, {"linf", 3 * x}}});
    series.orders = {fitted("l2", 3, 2)};
    series.orders[0].from = from, series.orders[0].to = to;
    return std::get<OrderGolden>(proposed(study_with(series, sweep))[0].expectation);
  };
  EXPECT_THAT(of("cells", 8, 32).finest, testing::ElementsAre(32, 32));
  EXPECT_THAT(of("cells", 32, 128).finest, testing::ElementsAre(128, 128));
  EXPECT_THAT(of("ppc", 8, 32).finest, testing::ElementsAre(32, 32));
  EXPECT_THAT(of("cfl", 16, 64).finest, testing::ElementsAre(16, 16)) << "the finest of time steps is the smallest";
  EXPECT_THAT(of("cells", 16, 64).window, testing::ElementsAre(16, 64));
  EXPECT_EQ(of("cells", 16, 64).points, 3);
}

TEST(Propose, TheFinestLevelIsStableMeasuredAndAboveZero) {
  Series series = convergent();
  const auto finest = [&] { return std::get<OrderGolden>(proposed(study_with(series))[0].expectation).finest; };
  EXPECT_THAT(finest(), testing::ElementsAre(64, 1e-4));
  for (const double bad : {0.0, -1.0, double(INFINITY), not_measured, 1e200}) {
    series.points[2].y["l2"] = bad;
    EXPECT_THAT(finest(), testing::ElementsAre(32, 4e-4)) << bad;
  }
  series.points[2].y = {{"linf", 1}};
  EXPECT_THAT(finest(), testing::ElementsAre(32, 4e-4));
}

TEST(Propose, ItsHeadNamesTheVersionOfAnotherCode) {
  Series series = convergent();
  series.code = records::OtherCode{"tiny", "0.3", "", "reference"};
  EXPECT_THAT(draft(study_with(series)), HasSubstr("\n# Of tiny 0.3.\n"));
}

TEST(Propose, WhatCouldNotPassIsNoGolden) {
  const auto refused = [](const std::function<void(Series&)>& change) {
    Series series = convergent();
    series.limit = cfl_limit(1, 1.01);
    change(series);
    return draft(study_with(series));
  };
  EXPECT_THAT(refused([](Series& s) { s.orders[0].from = 15; }), HasSubstr("over [15, 64]: no level at 15."));
  EXPECT_THAT(refused([](Series& s) { s.orders[0].to = 65; }), HasSubstr("over [16, 65]: no level at 65."));
  EXPECT_THAT(refused([](Series& s) { s.orders[0].half_width = 1.5; }), HasSubstr("known to ± 1.50 only."));
  EXPECT_THAT(refused([](Series& s) { s.limit = cfl_limit(0.1, 1); }),
              HasSubstr("it lies between 0.1 and 1, too far apart"));
  EXPECT_THAT(refused([](Series& s) { s.limit->found = false; }), HasSubstr("in cfl: nothing tried."));
  EXPECT_THAT(refused([](Series& s) { s.orders[0].order = not_measured; }), HasSubstr("none could be fitted."));
}

TEST(Propose, TheIntervalIsTheOneThatTheGateTakes) {
  Series series = convergent();
  series.orders[0].half_width = 3;
  series.orders[0].replicates = fits::ReplicateFit{12, 0.01, 0.5, 0.5};
  EXPECT_EQ(std::get<OrderGolden>(proposed(study_with(series))[0].expectation).interval, 0.5);
}

TEST(Propose, ThreePointsReachFromSegmentToSegment) {
  Series series = convergent();
  series.orders[0].segments = {{16, 32, 1.75}, {32, 64, 2.25}};
  EXPECT_EQ(std::get<OrderGolden>(proposed(study_with(series))[0].expectation).interval, 0.25);
  EXPECT_THAT(draft(study_with(series)), HasSubstr("# Measured 1.9995 ± 0.250 over [16, 64], 3 points"));
  series.orders[0].segments[1].order = 4.25;
  EXPECT_THAT(draft(study_with(series)), HasSubstr("known to ± 1.25 only."));
}

TEST(Propose, AWindowIsCalledAsymptoticWhereItWas) {
  const auto asymptotic = [](bool was) {
    Series series = convergent();
    series.orders[0].asymptotic = was;
    return std::get<OrderGolden>(proposed(study_with(series))[0].expectation).asymptotic;
  };
  EXPECT_TRUE(asymptotic(true));
  EXPECT_FALSE(asymptotic(false));
}

TEST(Propose, ATrialIsRefused) {
  StudyResult study = study_with(convergent());
  study.text = store::with_trial("", "shuffle = 3 in 1 of 1 series");
  EXPECT_THROW(propose_goldens(study, clean), UsageError);
}

TEST(Propose, LeavesTheMarkToTheReviewer) {
  for (const Golden& golden : proposed(study_with(convergent()))) EXPECT_FALSE(golden.reviewed);
  EXPECT_THAT(draft(study_with(convergent())), HasSubstr("add reviewed = \"DATE: who"));
}

TEST(Propose, AnErrorInEveryFittedNormOnce) {
  Series series = convergent();
  for (records::Point& point : series.points) point.y["linf"] = 2 * point.y["l2"];
  series.orders = {fitted("l2", 3, 2), fitted("linf", 3, 2), fitted("l2", 3, 2)};
  series.orders[2].from = 32;
  const auto goldens = proposed(study_with(series));
  ASSERT_EQ(goldens.size(), 5U);
  EXPECT_EQ(std::get<ErrorGolden>(goldens[3].expectation).norm, "l2");
  EXPECT_EQ(std::get<ErrorGolden>(goldens[4].expectation).norm, "linf");
}

TEST(Propose, AnIntervalIsRecordedWhereItsMarginPassesTheBand) {
  const auto interval_of = [](double half_width) {
    Series series = convergent();
    series.orders[0].half_width = half_width;
    return std::get<OrderGolden>(proposed(study_with(series))[0].expectation).interval;
  };
  EXPECT_EQ(interval_of(0.19), 0);
  EXPECT_EQ(interval_of(0.25), 0.25);
  EXPECT_EQ(interval_of(0.4), 0.4);
}

TEST(Propose, AWorseResultTakesNoGoldensPlace) {
  const std::vector<Golden> standing = proposed(study_with(convergent()));
  const auto propose_again = [&](double order, double error) {
    Series series = convergent();
    series.orders[0].order = order;
    series.points[2].y["l2"] = error;
    return parse_goldens(propose_goldens(study_with(series), clean, standing), "again.toml");
  };
  EXPECT_NO_THROW(propose_again(2, 1e-4));
  EXPECT_NO_THROW(propose_again(2.5, 1e-5)) << "better";
  EXPECT_THROW(propose_again(1.5, 1e-4), UsageError);
  EXPECT_THROW(propose_again(2, -0.05), UsageError) << "a number below 0 is no smaller error";
  try {
    propose_again(2, 2e-4);
    FAIL() << "accepted";
  } catch (const UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("is worse than its golden in new.toml:"));
  }
  Series crashed = convergent();
  crashed.points[2].status = Status::failed;
  try {
    propose_goldens(study_with(crashed), clean, standing);
    FAIL() << "accepted";
  } catch (const UsageError& e) {
    EXPECT_THAT(e.what(),
                testing::AllOf(HasSubstr("is worse than its golden in"), testing::Not(HasSubstr("measured  "))));
  }
  EXPECT_NO_THROW(propose_goldens(study_with(convergent()), clean, {Golden{"another", "x:1", ErrorGolden{}}}));
}

TEST(Propose, TheFinestLevelOfATimeStepSweepIsItsSmallest) {
  const auto goldens = proposed(study_with(convergent(), "cfl"));
  EXPECT_EQ(std::get<ErrorGolden>(goldens[1].expectation).at, 16);
}

TEST(Propose, LimitsAndCheckValuesRoundTrip) {
  Series series;
  series.name = "l = h";
  series.limit = cfl_limit(1.19, 1.2);
  StudyResult study = study_with(series);
  study.values = {{"slope", -1.5, ""}, {"gap", 3e-16, "largest gap"}, {"zero", 0, ""}, {"below", -2e-12, ""}};
  const auto goldens = proposed(study);
  ASSERT_EQ(goldens.size(), 5U);
  EXPECT_EQ(std::get<LimitGolden>(goldens[0].expectation).expected, 1.195);
  EXPECT_EQ(std::get<LimitGolden>(goldens[0].expectation).band, 0.05);
  EXPECT_DOUBLE_EQ(std::get<ValueGolden>(goldens[1].expectation).lower, -1.65);
  EXPECT_EQ(std::get<ValueGolden>(goldens[2].expectation).upper, 1e-14);
  EXPECT_EQ(std::get<ValueGolden>(goldens[3].expectation).upper, 1e-15);
  EXPECT_EQ(std::get<ValueGolden>(goldens[4].expectation).lower, -1e-10);
}

TEST(Propose, ALimitThatReplicatesDisagreeOnGetsAWiderBandAndSaysWhy) {
  Series series;
  series.name = "k = 16";
  series.limit = cfl_limit(0.19, 0.21);
  const StudyResult study = study_with(series);
  const auto goldens = proposed(study);
  ASSERT_EQ(goldens.size(), 1U);
  EXPECT_EQ(std::get<LimitGolden>(goldens[0].expectation).expected, 0.2);
  EXPECT_EQ(std::get<LimitGolden>(goldens[0].expectation).band, 0.1);
  EXPECT_THAT(draft(study), HasSubstr("why = \"it lies between 0.19 and 0.21"));
  EXPECT_EQ(run_gate(reviewed(study), {study}).exit_code(), 0);
}

TEST(Propose, WhatWasMeasuredPassesItsOwnProposal) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> exponent(-17, 3), order(-1, 4);
  for (int trial = 0; trial < 300; ++trial) {
    Series series = convergent();
    series.orders[0].order = order(generator);
    series.points[2].y["l2"] = std::pow(10, exponent(generator));
    const double limit = std::pow(10, exponent(generator));
    series.limit = cfl_limit(limit, 1.01 * limit);
    StudyResult study = study_with(series);
    study.values = {{"a", std::pow(10, exponent(generator)), ""}, {"b", -std::pow(10, exponent(generator)), ""}};
    const GateReport report = run_gate(reviewed(study), {study});
    EXPECT_EQ(report.results.size(), 5U);
    EXPECT_EQ(report.exit_code(), 0) << draft(study);
  }
}

}  // namespace mpmvv::goldens::propose_test
