#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/plan/study.hpp"

namespace mpmvv::claims::criterion_test {

using records::PartVerdict;
using records::Point;
using records::Series;
using records::Status;
using records::StudyResult;

using testing::HasSubstr;

/// e = h² on 8 to 64 cells, and a series twice as large that is unstable at 64.
StudyResult two_series() {
  StudyResult result;
  result.sweep = "cells";
  result.series = {Series{"good", {}, {}, {}}, Series{"bad", {}, {}, {}}};
  for (const double n : {8.0, 16.0, 32.0, 64.0}) {
    result.series[0].points.push_back({n, Status::ok, "", {{"l2", 1 / (n * n)}}});
    if (n < 64)
      result.series[1].points.push_back({n, Status::ok, "", {{"l2", 2 / (n * n)}}});
    else
      result.series[1].points.push_back({n, Status::unstable, "blown up", {}});
  }
  result.values = {{"round_off", 3e-16, "largest difference"}};
  fits::StabilityLimit limit;
  limit.key = "cfl", limit.stable = 0.99, limit.unstable = 1.01, limit.found = true;
  result.series[0].limit = limit;
  return result;
}

Criterion criterion(Criterion::Kind kind, const std::string& series, std::optional<double> at_least,
                    std::optional<double> at_most) {
  Criterion c;
  c.claim = "S-fig10", c.kind = kind, c.series = {series}, c.norm = "l2", c.window = {8, 64};
  c.at_least = at_least, c.at_most = at_most;
  c.reason = "why not";
  return c;
}

using Kind = Criterion::Kind;

TEST(Criterion, OrderInsideAndOutsideItsBounds) {
  EXPECT_EQ(judge(criterion(Kind::order, "good", 1.9, 2.1), two_series()).verdict, PartVerdict::holds);
  const records::ClaimPart part = judge(criterion(Kind::order, "good", 2.1, {}), two_series());
  EXPECT_EQ(part.verdict, PartVerdict::fails);
  EXPECT_EQ(part.reason, "why not");
  EXPECT_THAT(part.evidence, HasSubstr("= 2 "));
}

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

/// e = h² on 8 to 128 cells, larger by 2^scatter at every other level; order one more in `linf`.
StudyResult scattered(double scatter) {
  StudyResult result;
  result.sweep = "cells";
  result.series = {Series{"good", {}, {}, {}}};
  for (int k = 0; k < 5; ++k) {
    const double n = 8 * std::exp2(k), e = std::exp2(-2 * k + scatter * (k % 2));
    result.series[0].points.push_back({n, Status::ok, "", {{"l2", e}, {"linf", e / n}}});
  }
  return result;
}

TEST(Criterion, HowWellAnOrderIsKnownIsNoPartOfWhatWasFound) {
  StudyResult result = scattered(1);
  Criterion c = criterion(Kind::order, "good", 1.5, {});
  c.window = {8, 128};
  EXPECT_EQ(judge(c, result).found.at(0).what, "order of 'good' in l2 over cells 8 to 128");
  EXPECT_THAT(judge(c, result).evidence, HasSubstr("over cells 8 to 128 (±0.64) = 2"));
}

PartVerdict verdict_of_order(const StudyResult& result, std::optional<double> at_least, std::optional<double> at_most) {
  Criterion c = criterion(Kind::order, "good", at_least, at_most);
  c.window = {8, 128};
  return judge(c, result).verdict;
}

TEST(Criterion, AnOrderWhoseIntervalReachesAcrossABoundIsInconclusive) {  // 2 ± 0.64
  const StudyResult result = scattered(1);
  EXPECT_EQ(verdict_of_order(result, 1.3, {}), PartVerdict::holds);
  EXPECT_EQ(verdict_of_order(result, 1.5, {}), PartVerdict::inconclusive) << "2 is on the right side";
  EXPECT_EQ(verdict_of_order(result, 2.5, {}), PartVerdict::inconclusive) << "2 is on the wrong side";
  EXPECT_EQ(verdict_of_order(result, 2.7, {}), PartVerdict::fails);
  EXPECT_EQ(verdict_of_order(result, {}, 2.7), PartVerdict::holds);
  EXPECT_EQ(verdict_of_order(result, {}, 2.5), PartVerdict::inconclusive);
  EXPECT_EQ(verdict_of_order(result, {}, 1.5), PartVerdict::inconclusive);
  EXPECT_EQ(verdict_of_order(result, {}, 1.3), PartVerdict::fails);
  Criterion c = criterion(Kind::order, "good", 1.5, {});
  c.window = {8, 128};
  EXPECT_THAT(judge(c, result).evidence,
              HasSubstr("(±0.64) = 2 (asked: at least 1.5, but an interval reaches across)"));
  EXPECT_EQ(judge(c, result).reason, "") << "which says why it fails";
}

TEST(Criterion, OneThatFailsOutweighsOneWhoseIntervalReachesAcross) {
  StudyResult result = scattered(1);
  result.series.push_back(scattered(0).series[0]);
  result.series[1].name = "exact";
  Criterion c = criterion(Kind::order, "good", 2.1, {});
  c.window = {8, 128}, c.series = {"good", "exact"};
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::fails);
}

TEST(Criterion, AnOrderOfReplicatesHasTheirInterval) {
  const auto with_replicates = [](StudyResult result, double factor) {
    for (Point& point : result.series[0].points)
      for (const double other : {1 / factor, factor}) point.replicates["l2"].push_back(other * point.y["l2"]);
    return result;
  };
  EXPECT_EQ(verdict_of_order(with_replicates(scattered(0), 1.01), 1.9, {}), PartVerdict::holds);
  EXPECT_EQ(verdict_of_order(with_replicates(scattered(0), 2), 1.9, {}), PartVerdict::inconclusive);
  EXPECT_EQ(verdict_of_order(with_replicates(scattered(1), 1.01), 1.9, {}), PartVerdict::inconclusive)
      << "replicates agree, but their means are no line";
}

TEST(Criterion, TheScatterThatTwoNormsShareIsNoneOfTheirDifference) {
  StudyResult result = scattered(1);
  Criterion c = criterion(Kind::order_difference, "good", {}, -0.99);
  c.window = {8, 128}, c.over_norm = "linf";
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::holds) << judge(c, result).evidence;
  for (Point& point : result.series[0].points) point.y["linf"] = std::pow(point.x, -3);
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::inconclusive);
  result = scattered(0);
  for (Point& point : result.series[0].points)
    for (const double factor : {0.5, 2.0}) {
      point.replicates["l2"].push_back(factor * point.y["l2"]);
      point.replicates["linf"].push_back(factor * point.y["linf"]);
    }
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::holds) << "by replicates";
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

TEST(Criterion, ARatioOfLimitsReachesFromTheEndsOfBothBrackets) {  // [1, 1.5] over [2, 4]
  StudyResult result = two_series();
  result.series[1].limit = result.series[0].limit;
  result.series[0].limit->stable = 1, result.series[0].limit->unstable = 1.5;
  result.series[1].limit->stable = 2, result.series[1].limit->unstable = 4;
  const auto verdict = [&result](std::optional<double> at_least, std::optional<double> at_most) {
    Criterion ratio = criterion(Kind::limit_ratio, "good", at_least, at_most);
    ratio.over = "bad";
    return judge(ratio, result).verdict;
  };
  EXPECT_EQ(verdict(0.25, 0.75), PartVerdict::holds);
  EXPECT_EQ(verdict(0.26, {}), PartVerdict::inconclusive);
  EXPECT_EQ(verdict({}, 0.74), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0.76, {}), PartVerdict::fails);
  EXPECT_EQ(verdict({}, 0.24), PartVerdict::fails);
}

TEST(Criterion, AnUnstablePointBreaksALowerBoundOfTheOrderOnly) {
  EXPECT_EQ(judge(criterion(Kind::order, "bad", 1.5, 2.5), two_series()).verdict, PartVerdict::fails);
  const records::ClaimPart part = judge(criterion(Kind::order, "bad", {}, 2.5), two_series());
  EXPECT_EQ(part.verdict, PartVerdict::holds);
  EXPECT_THAT(part.evidence, HasSubstr("unstable at 64"));
}

TEST(Criterion, AFailedRunLeavesItOpen) {
  StudyResult result = two_series();
  result.series[0].points[1] = {16, Status::failed, "no memory", {}};
  EXPECT_EQ(judge(criterion(Kind::order, "good", 1.9, 2.1), result).verdict, PartVerdict::inconclusive);
  EXPECT_EQ(judge(criterion(Kind::error, "good", {}, 1), result).verdict, PartVerdict::inconclusive);
}

TEST(Criterion, ARunThatFailedIsNeitherStableNorUnstable) {
  StudyResult result = two_series();
  result.series[0].points[1].status = Status::failed;
  for (const double bound : {0.0, 0.7, 1.0}) {
    EXPECT_EQ(judge(criterion(Kind::status, "good", bound, {}), result).verdict, PartVerdict::inconclusive) << bound;
    EXPECT_EQ(judge(criterion(Kind::status, "good", {}, bound), result).verdict, PartVerdict::inconclusive) << bound;
  }
}

/// Fewer points that are left must not make a verdict milder.
TEST(Criterion, AnOrderFailsHoweverManyPointsAreUnstable) {
  for (std::size_t unstable = 1; unstable <= 4; ++unstable) {
    StudyResult result = two_series();
    for (std::size_t k = 4 - unstable; k < 4; ++k) result.series[0].points[k] = {8.0, Status::unstable, "blown up", {}};
    EXPECT_EQ(judge(criterion(Kind::order, "good", 1.5, {}), result).verdict, PartVerdict::fails) << unstable;
  }
}

TEST(Criterion, UnstablePointsHaveNoDifferenceOfOrders) {
  Criterion difference = criterion(Kind::order_difference, "bad", -0.1, 0.1);
  difference.over_norm = "l2";
  const records::ClaimPart part = judge(difference, two_series());
  EXPECT_EQ(part.verdict, PartVerdict::inconclusive);
  EXPECT_THAT(part.evidence, HasSubstr("'bad' is unstable at 64"));
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

TEST(Criterion, OrderDifferenceBetweenNorms) {
  StudyResult result = two_series();
  for (Point& point : result.series[0].points) point.y["linf"] = std::pow(point.x, -1.5);
  Criterion difference = criterion(Kind::order_difference, "good", 0.4999, 0.5001);
  difference.over_norm = "linf";
  EXPECT_EQ(judge(difference, result).verdict, PartVerdict::holds);
  difference.window = {8, 8};  // one point carries no order
  EXPECT_EQ(judge(difference, result).verdict, PartVerdict::inconclusive);
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
  EXPECT_THAT(judge(ratio, result).evidence, HasSubstr("at l2 1e-02: 'poor' never reaches it"));
  ratio.series = {"poor"}, ratio.over = "dear";
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::fails) << "what never gets there costs without end";
  EXPECT_THAT(judge(ratio, result).evidence, HasSubstr("at l2 1e-02: 'poor' never reaches it"));
  ratio.over = "poor";
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::fails) << "and so it does beside another that does not either";
  EXPECT_THAT(judge(ratio, result).evidence, HasSubstr("at l2 1e-02: neither ever reaches it"));
  ratio.at_least = 10, ratio.at_most = {};
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::inconclusive) << "but not so many times as much";
  result.series[2].points.clear();
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::inconclusive);
}

TEST(Criterion, WhatIsAwaitedKeepsAClaimFromBeingConfirmed) {
  EXPECT_EQ(judge(criterion(Kind::awaited, "", {}, {}), two_series()).verdict, PartVerdict::inconclusive);
}

TEST(Criterion, AnUnknownSeriesIsInconclusive) {
  EXPECT_EQ(judge(criterion(Kind::order, "ugly", 1, 2), two_series()).verdict, PartVerdict::inconclusive);
}

}  // namespace mpmvv::claims::criterion_test
