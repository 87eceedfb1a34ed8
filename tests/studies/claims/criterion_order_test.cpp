#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/studies/claims/criterion_samples.hpp"

namespace mpmvv::claims::criterion_order_test {

using namespace criterion_samples;
using records::PartVerdict;
using records::Point;

using testing::HasSubstr;

TEST(Criterion, OrderInsideAndOutsideItsBounds) {
  EXPECT_EQ(judge(criterion(Kind::order, "good", 1.9, 2.1), two_series()).verdict, PartVerdict::holds);
  const records::ClaimPart part = judge(criterion(Kind::order, "good", 2.1, {}), two_series());
  EXPECT_EQ(part.verdict, PartVerdict::fails);
  EXPECT_EQ(part.reason, "why not");
  EXPECT_THAT(part.evidence, HasSubstr("= 2 "));
}

TEST(Criterion, ThatAPointIsLeftOutIsSaidOfThoseInTheWindow) {
  StudyResult result = two_series();
  result.series[0].points.push_back({128, Status::ok, "", {{"l2", 1e-5}, {"output_floor", 1e-5}}});
  result.series[0].points[1].y["l2"] = 0;
  Criterion c = criterion(Kind::order, "good", 1.9, {});
  EXPECT_THAT(judge(c, result).evidence, HasSubstr("'good': 1 of 4 stable points are no use (asked"));
  c.window = {32, 128};
  EXPECT_THAT(judge(c, result).evidence, HasSubstr("1 of 3 stable points are no use, left out: 128 (within 3 times"));
}

TEST(Criterion, HowWellAnOrderIsKnownIsNoPartOfWhatWasFound) {
  StudyResult result = scattered(1);
  Criterion c = criterion(Kind::order, "good", 1.5, {});
  c.window = {8, 128};
  EXPECT_EQ(judge(c, result).found.at(0).what, "order of 'good' in l2 over cells 8 to 128");
  EXPECT_THAT(judge(c, result).evidence, HasSubstr("over cells 8 to 128 = 2 ± 0.64 (finest segment 3.00)"));
}

TEST(Criterion, SaysInWordsThatAnOrderIsNotKnown) {
  StudyResult result = scattered(0);
  result.series[0].points.resize(1);
  const records::ClaimPart part = judge(criterion(Kind::order, "good", 1.5, {}), result);
  EXPECT_EQ(part.verdict, PartVerdict::inconclusive);
  EXPECT_THAT(part.evidence, HasSubstr("is not known"));
  EXPECT_THAT(part.evidence, testing::Not(HasSubstr("nan")));
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
              HasSubstr("= 2 ± 0.64 (finest segment 3.00) (asked: at least 1.5, but an interval reaches across)"));
  EXPECT_EQ(judge(c, result).reason, "") << "which says why it fails";
}

/// Segments of 1.5 and 2.5: fewer points are not the surer ones.
TEST(Criterion, AnOrderOfThreePointsReachesFromSegmentToSegment) {
  StudyResult result = scattered(0.5);
  result.series[0].points.resize(3);
  EXPECT_EQ(verdict_of_order(result, 1.4, 2.6), PartVerdict::holds);
  EXPECT_EQ(verdict_of_order(result, 1.6, {}), PartVerdict::inconclusive);
  EXPECT_EQ(verdict_of_order(result, 2.6, {}), PartVerdict::fails);
}

/// A verdict is on the order over the window; that the last segment leaves it is said beside it.
TEST(Criterion, SaysWhereTheFinestSegmentLeavesTheIntervalOfAnOrder) {
  StudyResult result = scattered(0);
  result.series[0].points.back().y["l2"] *= 1.5;  // its segment has an order of 1.415
  const auto judged = [&] {
    Criterion c = criterion(Kind::order, "good", 1.6, {});
    c.window = {8, 128};
    return judge(c, result);
  };
  EXPECT_EQ(judged().verdict, PartVerdict::holds);
  EXPECT_THAT(judged().evidence, HasSubstr("= 1.883 ± 0.21 (finest segment 1.42)"));
  result.sweep = "cfl";  // now the finest segment is the first
  EXPECT_THAT(judged().evidence, HasSubstr("= -1.883 ± 0.21 (asked"));
}

/// Each series must pass.
TEST(Criterion, ASeriesThatFailsDecidesWhereARunOfAnotherFailed) {
  StudyResult result = scattered(0);
  result.series.push_back(result.series[0]);
  result.series[1].name = "broken";
  result.series[1].points[2] = {32, Status::failed, "no licence", {}};
  const auto judged = [&](Kind kind, double at_least, double at_most) {
    Criterion c = criterion(kind, "good", at_least, at_most);
    c.window = {8, 128}, c.series = {"good", "broken"};
    return judge(c, result);
  };
  EXPECT_EQ(judged(Kind::order, 1.9, 2.1).verdict, PartVerdict::inconclusive);
  EXPECT_EQ(judged(Kind::order, 2.1, 2.2).verdict, PartVerdict::fails);
  EXPECT_THAT(judged(Kind::order, 2.1, 2.2).evidence, HasSubstr("'broken' failed at cells = 32"));
  EXPECT_EQ(judged(Kind::error, 0, 2).verdict, PartVerdict::inconclusive);
  EXPECT_EQ(judged(Kind::error, 0, 0.01).verdict, PartVerdict::fails);
  const auto& found = judged(Kind::order, 2.1, 2.2).found;
  ASSERT_EQ(found.size(), 2u) << "and not the order of the points that are left of 'broken'";
  EXPECT_EQ(found[0].what, "order of 'good' in l2 over cells 8 to 128");
  EXPECT_EQ(found[1].what, "'broken' failed at cells = 32");
  EXPECT_TRUE(std::isnan(found[1].value));
  result.series[0].name = "other";
  result.series[1].name = "good";
  EXPECT_EQ(judged(Kind::order, 2.1, 2.2).verdict, PartVerdict::inconclusive) << "what lacks a point cannot fail";
  EXPECT_EQ(judged(Kind::error, 0, 0.01).verdict, PartVerdict::fails) << "but at each of its points an error can";
}

TEST(Criterion, AnUnknownSeriesHidesNoneThatFails) {
  for (const std::vector<std::string>& names : {std::vector<std::string>{"ugly", "good"}, {"good", "ugly"}}) {
    Criterion c = criterion(Kind::order, "good", 2.1, {});
    c.series = names;
    EXPECT_EQ(judge(c, two_series()).verdict, PartVerdict::fails);
    c.at_least = 1.9;
    EXPECT_EQ(judge(c, two_series()).verdict, PartVerdict::inconclusive);
    EXPECT_THAT(judge(c, two_series()).evidence, HasSubstr("there is no series 'ugly'"));
  }
}

/// An error that falls with the step of the run, 1/6 and so on, and not with the Courant number asked for.
TEST(Criterion, ADifferenceOfOrdersTakesTheCourantNumbersOfTheRuns) {
  StudyResult result;
  result.sweep = "cfl";
  result.series = {Series{"good", {}, {}, {}}};
  const std::pair<double, double> steps[] = {{0.2, 1. / 6}, {0.4, 1. / 3}, {0.6, 1. / 2}, {1, 1}};
  for (const auto& [asked, run] : steps)
    result.series[0].points.push_back({asked, Status::ok, "", {{"l2", run}, {"linf", run * run}, {"cfl", run}}});
  Criterion c = criterion(Kind::order_difference, "good", -1 - 1e-9, -1 + 1e-9);
  c.window = {0.2, 1}, c.over_norm = "linf";
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::holds) << judge(c, result).evidence;
}

TEST(Criterion, OneThatFailsOutweighsOneWhoseIntervalReachesAcross) {
  StudyResult result = scattered(1);
  result.series.push_back(scattered(0).series[0]);
  result.series[1].name = "exact";
  Criterion c = criterion(Kind::order, "good", 2.1, {});
  c.window = {8, 128}, c.series = {"good", "exact"};
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::fails);
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

TEST(Criterion, AnUnstablePointBreaksALowerBoundOfTheOrderOnly) {
  EXPECT_EQ(judge(criterion(Kind::order, "bad", 1.5, 2.5), two_series()).verdict, PartVerdict::fails);
  const records::ClaimPart part = judge(criterion(Kind::order, "bad", {}, 2.5), two_series());
  EXPECT_EQ(part.verdict, PartVerdict::holds);
  EXPECT_THAT(part.evidence, HasSubstr("unstable at 64"));
}

/// Fewer points that are left must not make a verdict milder.
TEST(Criterion, AnOrderFailsHoweverManyPointsAreUnstable) {
  for (std::size_t unstable = 1; unstable <= 4; ++unstable) {
    StudyResult result = two_series();
    for (std::size_t k = 4 - unstable; k < 4; ++k) result.series[0].points[k] = {8.0, Status::unstable, "blown up", {}};
    EXPECT_EQ(judge(criterion(Kind::order, "good", 1.5, {}), result).verdict, PartVerdict::fails) << unstable;
  }
}

/// Where the error of the stable ones is no positive number.
TEST(Criterion, ALowerBoundFailsByAnUnstablePointEvenIfTheOthersAreNoUse) {
  StudyResult result = scattered(0);
  for (Point& point : result.series[0].points) point.y["l2"] = -1;
  result.series[0].points.back() = {128, Status::unstable, "blown up", {}};
  Criterion c = criterion(Kind::order, "good", 1.5, {});
  c.window = {8, 128};
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::fails);
  EXPECT_EQ(verdict_of_order(result, {}, 1.5), PartVerdict::inconclusive);
}

/// Second order on 8 to 128 cells; all but the first `stable` runs are unstable.
StudyResult stable_at_first(std::size_t stable) {
  StudyResult result = scattered(0);
  for (std::size_t k = stable; k < 5; ++k) {
    result.series[0].points[k].status = Status::unstable;
    result.series[0].points[k].y = {};
  }
  return result;
}

TEST(Criterion, AnUpperBoundIsNotJudgedByTheLastTwoPointsThatAreStable) {
  EXPECT_EQ(verdict_of_order(stable_at_first(3), {}, 2.5), PartVerdict::holds);
  EXPECT_EQ(verdict_of_order(stable_at_first(2), {}, 2.5), PartVerdict::inconclusive);
  EXPECT_EQ(verdict_of_order(stable_at_first(2), {}, 1.5), PartVerdict::inconclusive);
  EXPECT_EQ(verdict_of_order(stable_at_first(2), 1.5, 2.5), PartVerdict::fails) << "by its lower bound";
  Criterion c = criterion(Kind::order, "good", {}, 2.5);
  c.window = {8, 128};
  EXPECT_THAT(judge(c, stable_at_first(2)).evidence, HasSubstr("too few points of 'good' are stable: 2 of at least 3"));
  StudyResult replicated = stable_at_first(2);
  for (Point& point : replicated.series[0].points)
    for (const double factor : {1 / 1.01, 1.01})
      if (point.status == Status::ok) point.replicates["l2"].push_back(factor * point.y["l2"]);
  EXPECT_EQ(verdict_of_order(replicated, {}, 2.5), PartVerdict::holds) << "which have an interval";
}

TEST(Criterion, AWindowOfTwoLevelsIsJudgedByBoth) {
  StudyResult result = scattered(0);
  result.series[0].points.resize(2);
  EXPECT_EQ(verdict_of_order(result, {}, 2.5), PartVerdict::holds);
  EXPECT_EQ(verdict_of_order(result, {}, 1.5), PartVerdict::fails);
}

TEST(Criterion, AnOrderSaysWhereRunsFailed) {
  StudyResult result = two_series();
  for (const std::size_t k : {1, 3}) {
    result.series[0].points[k].status = Status::failed;
    result.series[0].points[k].y = {};
  }
  const records::ClaimPart part = judge(criterion(Kind::order, "good", 1.5, {}), result);
  EXPECT_EQ(part.verdict, PartVerdict::inconclusive);
  EXPECT_THAT(part.evidence, HasSubstr("'good' failed at cells = 16, 64"));
}

TEST(Criterion, UnstablePointsHaveNoDifferenceOfOrders) {
  Criterion difference = criterion(Kind::order_difference, "bad", -0.1, 0.1);
  difference.over_norm = "l2";
  const records::ClaimPart part = judge(difference, two_series());
  EXPECT_EQ(part.verdict, PartVerdict::inconclusive);
  EXPECT_THAT(part.evidence, HasSubstr("'bad' is unstable at 64"));
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

}  // namespace mpmvv::claims::criterion_order_test
