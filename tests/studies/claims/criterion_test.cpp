#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/studies/claims/criterion_samples.hpp"

namespace mpmvv::claims::criterion_test {

using namespace criterion_samples;
using records::PartVerdict;
using records::Point;

using testing::HasSubstr;

TEST(Criterion, SaysWhatWasAskedAndEachNumberThatWasFound) {
  const records::ClaimPart order = judge(criterion(Kind::order, "good", 1.9, {}), two_series());
  EXPECT_EQ(order.measure, "order");
  EXPECT_EQ(order.at_least, 1.9);
  EXPECT_EQ(order.at_most, std::nullopt);
  ASSERT_EQ(order.found.size(), 1U);
  EXPECT_EQ(order.found[0].what, "order of 'good' in l2 over cells 8 to 64");
  EXPECT_NEAR(order.found[0].value, 2, 1e-12);
  const records::ClaimPart errors = judge(criterion(Kind::error, "bad", {}, 1), two_series());
  ASSERT_EQ(errors.found.size(), 4U);
  EXPECT_EQ(errors.found[1].what, "l2 of 'bad' at cells = 16");
  EXPECT_EQ(errors.found[1].value, 2. / 256);
  EXPECT_TRUE(std::isinf(errors.found[3].value)) << "unstable";
  EXPECT_EQ(judge(criterion(Kind::shown, "", {}, {}), two_series()).measure, "shown");
}

TEST(Criterion, ANumberIsToldFromABoundThatItMisses) {
  const auto part = judge(criterion(Kind::error, "bad", 0.00781249, {}), two_series());
  EXPECT_THAT(part.evidence, HasSubstr("at cells = 16 = 0.0078125;")) << part.evidence;
  const auto exact = judge(criterion(Kind::error, "bad", 1, 1), two_series());
  EXPECT_THAT(exact.evidence, HasSubstr("(asked: 1)"));
}

TEST(Criterion, ALimitWhoseBracketReachesAcrossABoundIsInconclusive) {
  const auto verdict = [](double at_least, double stable, double unstable) {
    StudyResult result = two_series();
    result.series[0].limit->stable = stable, result.series[0].limit->unstable = unstable;
    return judge(criterion(Kind::limit, "good", at_least, {}), result).verdict;
  };
  for (const auto& [stable, unstable] : {std::pair{0.8, 1.2}, std::pair{1.2, 0.8}}) {
    EXPECT_EQ(verdict(0.8, stable, unstable), PartVerdict::holds);
    EXPECT_EQ(verdict(0.9, stable, unstable), PartVerdict::inconclusive);
    EXPECT_EQ(verdict(1.1, stable, unstable), PartVerdict::inconclusive);
    EXPECT_EQ(verdict(1.3, stable, unstable), PartVerdict::fails);
  }
}

/// From 0.25 to 1, stable below the limit or above it.
TEST(Criterion, ALimitBeyondAllThatWasTriedIsDecidedWhereItsSideDoes) {
  const auto judged = [](bool is_stable, bool stable_below, std::optional<double> at_least,
                         std::optional<double> at_most) {
    StudyResult result = two_series();
    fits::StabilityLimit limit;
    limit.key = "cfl";
    limit.probes = {{0.25, is_stable, ""}, {0.5, is_stable, ""}, {1, is_stable, ""}};
    (is_stable ? limit.stable : limit.unstable) = is_stable == stable_below ? 1 : 0.25;
    result.series[0].limit = limit;
    return judge(criterion(Kind::limit, "good", at_least, at_most), result);
  };
  EXPECT_EQ(judged(false, true, 0.8, {}).verdict, PartVerdict::fails) << "below 0.25";
  EXPECT_EQ(judged(false, true, {}, 0.8).verdict, PartVerdict::holds);
  EXPECT_EQ(judged(false, true, 0.2, {}).verdict, PartVerdict::inconclusive);
  EXPECT_EQ(judged(true, true, 0.8, {}).verdict, PartVerdict::holds) << "above 1";
  EXPECT_EQ(judged(true, true, {}, 2).verdict, PartVerdict::inconclusive);
  EXPECT_EQ(judged(false, false, 0.8, {}).verdict, PartVerdict::holds) << "above 1";
  EXPECT_EQ(judged(true, false, {}, 0.8).verdict, PartVerdict::holds) << "below 0.25";
  EXPECT_THAT(judged(false, true, 0.8, {}).evidence,
              HasSubstr("cfl limit of 'good', unstable at all values tried, down to 0.25 = 0.25 or less"));
}

TEST(Criterion, AFailedRunLeavesItOpen) {
  StudyResult result = two_series();
  result.series[0].points[1] = {16, Status::failed, "no memory", {}};
  EXPECT_EQ(judge(criterion(Kind::order, "good", 1.9, 2.1), result).verdict, PartVerdict::inconclusive);
  EXPECT_EQ(judge(criterion(Kind::error, "good", {}, 1), result).verdict, PartVerdict::inconclusive);
}

TEST(Criterion, EveryMeasureOfErrorsSaysThatARunFailed) {
  StudyResult result = two_series();
  result.series[0].points[1] = {16, Status::failed, "no memory", {}};
  for (const Kind kind : {Kind::error, Kind::error_ratio, Kind::spread, Kind::slope_ratio, Kind::slope_share}) {
    Criterion c = criterion(kind, "good", {}, 1e9);
    c.over = "bad", c.window = {8, 32};
    const records::ClaimPart part = judge(c, result);
    EXPECT_EQ(part.verdict, PartVerdict::inconclusive) << support::to_string(kind);
    EXPECT_THAT(part.evidence, HasSubstr("'good' failed at cells = 16 (asked")) << support::to_string(kind);
  }
  Criterion ratio = criterion(Kind::error_ratio, "bad", {}, 1e9);
  ratio.over = "good", ratio.window = {8, 32};
  EXPECT_THAT(judge(ratio, result).evidence, HasSubstr("; 'good' failed at cells = 16 (asked"));
  Criterion of_both = criterion(Kind::error, "good", {}, 1);
  of_both.series = {"good", "bad"};
  const records::ClaimPart part = judge(of_both, result);
  EXPECT_EQ(part.verdict, PartVerdict::fails) << "as 'bad' is unstable";
  EXPECT_EQ(part.found.back().what, "'good' failed at cells = 16");
  EXPECT_TRUE(std::isnan(part.found.back().value));
}

TEST(Criterion, ARunThatFailedIsNeitherStableNorUnstable) {
  StudyResult result = two_series();
  result.series[0].points[1].status = Status::failed;
  for (const double bound : {0.0, 0.7, 1.0}) {
    EXPECT_EQ(judge(criterion(Kind::status, "good", bound, {}), result).verdict, PartVerdict::inconclusive) << bound;
    EXPECT_EQ(judge(criterion(Kind::status, "good", {}, bound), result).verdict, PartVerdict::inconclusive) << bound;
  }
}

TEST(Criterion, AWindowWithoutPointsIsInconclusive) {
  for (const Kind kind : {Kind::order, Kind::order_difference, Kind::error, Kind::error_ratio, Kind::spread,
                          Kind::slope_ratio, Kind::slope_share, Kind::status})
    for (const std::vector<std::string>& names : {std::vector<std::string>{"good"}, {"good", "short"}}) {
      StudyResult result = two_series();
      result.series.push_back({"short", {{4, Status::ok, "", {{"l2", 1}}}}, {}, {}});
      Criterion c = criterion(kind, "good", {}, 1e9);
      c.series = names, c.over = "good", c.over_norm = "l2";
      if (names.size() == 1) c.window = {100, 200};
      const records::ClaimPart part = judge(c, result);
      EXPECT_EQ(part.verdict, PartVerdict::inconclusive) << support::to_string(kind);
      EXPECT_THAT(part.evidence, HasSubstr("has no point over cells")) << support::to_string(kind);
    }
}

TEST(Criterion, AnUnstableErrorIsInfinite) {
  EXPECT_EQ(judge(criterion(Kind::error, "bad", {}, 1), two_series()).verdict, PartVerdict::fails);
  Criterion ratio = criterion(Kind::error_ratio, "bad", 1.99, {});
  ratio.over = "good";
  EXPECT_EQ(judge(ratio, two_series()).verdict, PartVerdict::holds);
  ratio.at_most = 2.01;
  EXPECT_EQ(judge(ratio, two_series()).verdict, PartVerdict::fails);
}

/// An energy loss lies below 0 where energy was gained.
TEST(Criterion, NoRatioIsTakenWhereTheSignWouldDecide) {
  const auto judged = [](Kind kind, double own, double other) {
    StudyResult result = two_series();
    result.series[0].points[1].y["l2"] = own, result.series[1].points[1].y["l2"] = other;
    Criterion c = criterion(kind, "good", {}, 1e9);
    c.over = "bad", c.window = {8, 32};
    return judge(c, result);
  };
  for (const double own : {-0.02, 0.0}) EXPECT_EQ(judged(Kind::spread, own, 1).verdict, PartVerdict::inconclusive);
  EXPECT_THAT(judged(Kind::spread, -0.02, 1).evidence,
              HasSubstr("'good' has l2 = -0.02 at cells = 16, and a ratio needs numbers above 0"));
  EXPECT_EQ(judged(Kind::error_ratio, 0, 0.01).verdict, PartVerdict::holds) << "nothing of something";
  for (const auto& [own, other] : {std::pair{-0.02, 0.01}, {0.02, -0.01}, {-0.02, -0.01}, {0.02, 0.0}, {0.0, 0.0}})
    EXPECT_EQ(judged(Kind::error_ratio, own, other).verdict, PartVerdict::inconclusive) << own << " " << other;
  EXPECT_THAT(judged(Kind::error_ratio, -0.02, 0.01).evidence, HasSubstr("'good' has l2 = -0.02 at cells = 16, and"));
  EXPECT_THAT(judged(Kind::error_ratio, 0.02, -0.01).evidence, HasSubstr("'bad' has l2 = -0.01 at cells = 16, and"));
  EXPECT_EQ(judged(Kind::error_ratio, -0.02, INFINITY).verdict, PartVerdict::inconclusive) << "beside an unstable run";
}

TEST(Criterion, SlopesAgainstTheSweptValue) {  // 3 + 2 x over 3 + 4 x, and over 3 + 4 x at its first point
  StudyResult result;
  result.sweep = "order";
  result.series = {Series{"slow", {}, {}, {}}, Series{"steep", {}, {}, {}}};
  for (const double x : {1.0, 2.0, 4.0, 8.0}) {
    result.series[0].points.push_back({x, Status::ok, "", {{"l2", 3 + 2 * x}}});
    result.series[1].points.push_back({x, Status::ok, "", {{"l2", 3 + 4 * x}}});
  }
  Criterion ratio = criterion(Kind::slope_ratio, "slow", 0.5 - 1e-12, 0.5 + 1e-12);
  ratio.over = "steep", ratio.window = {1, 8};
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::holds);
  Criterion share = criterion(Kind::slope_share, "slow", 2.0 / 7 - 1e-12, 2.0 / 7 + 1e-12);
  share.over = "steep", share.window = {1, 8};
  EXPECT_EQ(judge(share, result).verdict, PartVerdict::holds);
  result.series[0].points[1].status = Status::unstable;
  EXPECT_NE(judge(ratio, result).verdict, PartVerdict::holds);
}

TEST(Criterion, TwoUnstableRunsAreEqual) {
  Criterion ratio = criterion(Kind::error_ratio, "bad", 1, 1);
  ratio.over = "bad";
  EXPECT_EQ(judge(ratio, two_series()).verdict, PartVerdict::holds);
}

TEST(Criterion, SpreadStatusLimitValue) {
  EXPECT_EQ(judge(criterion(Kind::spread, "good", 63.9, 64.1), two_series()).verdict, PartVerdict::holds);
  EXPECT_EQ(judge(criterion(Kind::status, "bad", 0.74, 0.76), two_series()).verdict, PartVerdict::holds);
  EXPECT_EQ(judge(criterion(Kind::limit, "good", 0.95, 1.05), two_series()).verdict, PartVerdict::holds);
  EXPECT_EQ(judge(criterion(Kind::limit, "bad", 0.95, 1.05), two_series()).verdict, PartVerdict::inconclusive);
  Criterion value = criterion(Kind::value, "", {}, 1e-14);
  value.name = "round_off";
  EXPECT_EQ(judge(value, two_series()).verdict, PartVerdict::holds);
  value.name = "unknown";
  EXPECT_EQ(judge(value, two_series()).verdict, PartVerdict::inconclusive);
}

/// e = cost^-1/2 against one that is as accurate at four times the cost, and one that never gets below 0.1.
TEST(Criterion, CostRatioAtEachPowerOfTen) {
  StudyResult result;
  result.series = {Series{"cheap", {}, {}, {}}, Series{"dear", {}, {}, {}}, Series{"poor", {}, {}, {}}};
  for (const double e : {0.5, 0.2, 0.05, 0.02, 0.005}) {
    const auto point = [&](double cost, double error) {
      return Point{1 / e, Status::ok, "", {{"l2", error}, {"step_seconds", cost}}};
    };
    result.series[0].points.push_back(point(1 / (e * e), e));
    result.series[1].points.push_back(point(4 / (e * e), e));
    result.series[2].points.push_back(point(1 / (e * e), 0.1 + e));
  }
  Criterion ratio = criterion(Kind::cost_ratio, "cheap", 0.249999, 0.250001);
  ratio.over = "dear", ratio.window = {0.01, 0.1};
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::holds) << judge(ratio, result).evidence;
  EXPECT_THAT(judge(ratio, result).evidence, HasSubstr("at l2 1e-02 = 0.25"));
  ratio.over = "poor", ratio.at_least = {};
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::holds) << judge(ratio, result).evidence;
  EXPECT_THAT(judge(ratio, result).evidence, HasSubstr("at l2 1e-02 = 0 ('poor' never reaches it)"));
  ratio.series = {"poor"}, ratio.over = "dear";
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::fails) << "what never gets there costs without end";
  EXPECT_THAT(judge(ratio, result).evidence, HasSubstr("at l2 1e-02 = inf ('poor' never reaches it)"));
  ratio.over = "poor";
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::inconclusive) << "beside another that does not either";
  EXPECT_THAT(judge(ratio, result).evidence, HasSubstr("at l2 1e-02 is not known (neither ever reaches it)"));
  ratio.at_least = 10, ratio.at_most = {};
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::inconclusive);
  result.series[2].points.clear();
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::inconclusive);
}

/// Runs whose cost was measured, the last of "bad" unstable: `unstable` of them in all.
StudyResult with_cost(std::size_t unstable) {
  StudyResult result = two_series();
  for (records::Series& series : result.series)
    for (Point& point : series.points)
      if (point.status == Status::ok) point.y["step_seconds"] = point.x;
  for (std::size_t k = 4 - unstable; k < 4; ++k) {
    result.series[1].points[k].status = Status::unstable;
    result.series[1].points[k].y = {};
  }
  return result;
}

/// Both of two runs are unstable: their ratio counts as 1 but is no evidence.
TEST(Criterion, ARatioOfTwoUnstableRunsSaysSo) {
  StudyResult result = two_series();
  for (records::Series& series : result.series) series.points[1] = {16, Status::unstable, "", {}};
  Criterion ratio = criterion(Kind::error_ratio, "good", {}, 1);
  ratio.over = "bad", ratio.window = {16, 16};
  const records::ClaimPart part = judge(ratio, result);
  EXPECT_EQ(part.verdict, PartVerdict::holds);
  EXPECT_THAT(part.evidence, HasSubstr("at cells = 16 = 1 (both unstable) (asked: at most 1)"));
}

TEST(Criterion, ASpreadGetsNoMilderTheMoreRunsAreUnstable) {
  for (std::size_t unstable = 1; unstable <= 4; ++unstable) {
    const records::ClaimPart part = judge(criterion(Kind::spread, "bad", {}, 2), with_cost(unstable));
    EXPECT_EQ(part.verdict, PartVerdict::fails) << unstable;
    EXPECT_THAT(part.evidence, HasSubstr("= inf ")) << unstable;
    EXPECT_EQ(judge(criterion(Kind::spread, "bad", 1, 2), with_cost(unstable)).verdict, PartVerdict::fails) << unstable;
  }
  EXPECT_EQ(judge(criterion(Kind::spread, "bad", 2, {}), with_cost(3)).verdict, PartVerdict::holds);
  EXPECT_EQ(judge(criterion(Kind::spread, "bad", 2, {}), with_cost(4)).verdict, PartVerdict::inconclusive)
      << "nothing shows how far apart they lie";
}

TEST(Criterion, ARatioOfCostsGetsNoMilderTheMoreRunsAreUnstable) {
  const auto judged = [](const char* series, const char* over, std::optional<double> at_least,
                         std::optional<double> at_most, const StudyResult& result) {
    Criterion ratio = criterion(Kind::cost_ratio, series, at_least, at_most);
    ratio.over = over, ratio.window = {1e-3, 1e-3};
    return judge(ratio, result);
  };
  for (std::size_t unstable = 1; unstable <= 4; ++unstable) {
    const StudyResult result = with_cost(unstable);
    EXPECT_EQ(judged("bad", "good", {}, 1, result).verdict, PartVerdict::fails) << unstable;
    EXPECT_EQ(judged("bad", "bad", 0.5, 2, result).verdict, PartVerdict::inconclusive) << unstable;
    EXPECT_EQ(judged("good", "bad", {}, 1, result).verdict, PartVerdict::holds) << unstable;
  }
  EXPECT_THAT(judged("bad", "good", {}, 1, with_cost(4)).evidence,
              HasSubstr("at l2 1e-03 = inf ('bad' never reaches it)"));
  StudyResult unmeasured = with_cost(3);
  unmeasured.series[1].points[0].y.erase("step_seconds");
  EXPECT_EQ(judged("bad", "good", {}, 1, unmeasured).verdict, PartVerdict::inconclusive) << "a sound run has no cost";
  EXPECT_THAT(judged("bad", "good", {}, 1, unmeasured).evidence, HasSubstr("no cost of 'bad'"));
}

TEST(Criterion, WhatIsAwaitedKeepsAClaimFromBeingConfirmed) {
  Criterion awaited = criterion(Kind::awaited, "", {}, {});
  EXPECT_EQ(judge(awaited, two_series()).verdict, PartVerdict::inconclusive);
  awaited.reason = "the paper does not print the density";
  EXPECT_EQ(judge(awaited, two_series()).evidence, awaited.reason) << "no run says more";
}

TEST(Criterion, AnUnknownSeriesIsInconclusive) {
  EXPECT_EQ(judge(criterion(Kind::order, "ugly", 1, 2), two_series()).verdict, PartVerdict::inconclusive);
}

}  // namespace mpmvv::claims::criterion_test
