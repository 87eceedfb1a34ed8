#include "studies/fits/work_precision.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "studies/claims/samples.hpp"

namespace mpmvv::fits::work_precision_test {

using records::Status;

using testing::ElementsAre;
using testing::IsEmpty;

TEST(WorkPrecision, OnlySoundRunsWithACostArePoints) {
  records::Series series{"s", {}, {}, {}};
  series.points = {{8, Status::ok, "", {{"l2", 0.1}, {"step_seconds", 2}}},
                   {16, Status::ok, "", {{"l2", 0.1}}},
                   {32, Status::unstable, "", {{"l2", 0.1}, {"step_seconds", 2}}},
                   {64, Status::ok, "", {{"l1", 0.1}, {"step_seconds", 2}}}};
  EXPECT_THAT(claims::work_points(series, "l2"), ElementsAre(WorkPoint{2, 0.1}));
}

TEST(WorkPrecision, NoPointOfTheFrontIsBeatenAndEveryOtherIs) {
  std::vector<WorkPoint> points;
  for (int k = 0; k < 200; ++k)
    points.push_back({1 + std::fmod(k * 0.6180339887, 1), 1 + std::fmod(k * 0.7548776662, 1)});
  const auto front = pareto_front(points);
  const auto beats = [](const WorkPoint& a, const WorkPoint& b) {
    return a.cost <= b.cost && a.error <= b.error && a != b;
  };
  for (const WorkPoint& p : points) {
    const bool beaten = std::any_of(points.begin(), points.end(), [&](const WorkPoint& q) { return beats(q, p); });
    EXPECT_EQ(std::find(front.begin(), front.end(), p) != front.end(), !beaten);
  }
  EXPECT_THAT(pareto_front({}), IsEmpty());
}

TEST(WorkPrecision, RoundOffMakesNoRunMoreAccurate) {
  EXPECT_THAT(pareto_front({{1, 2.63256775652536e-05}, {2, 2.63256775652494e-05}, {3, 2.63e-05}}),
              ElementsAre(WorkPoint{1, 2.63256775652536e-05}, WorkPoint{3, 2.63e-05}));
}

TEST(WorkPrecision, CostOfAPowerLawIsExactBetweenItsPoints) {
  std::vector<WorkPoint> points;
  for (const double cost : {1.0, 4.0, 16.0}) points.push_back({cost, std::pow(cost, -1.5)});
  const auto front = pareto_front(points);
  for (const double cost : {1.0, 1.7, 4.0, 9.0, 16.0})
    EXPECT_NEAR(work_to_reach(std::pow(cost, -1.5) * (1 + 1e-14), front).cost, cost, 1e-12 * cost);
  EXPECT_EQ(work_to_reach(2, front).cost, 1) << "the cheapest run does";
  EXPECT_TRUE(std::isinf(work_to_reach(0.01, front).cost));
  EXPECT_TRUE(std::isinf(work_to_reach(0.01, {}).cost));
}

TEST(WorkPrecision, RangesAddInSquaresBetweenTwoPoints) {
  const std::vector<WorkPoint> front{{1, 0.1, 0.2}, {100, 0.001, 20}};
  EXPECT_EQ(work_to_reach(0.5, front), (WorkPoint{1, 0.5, 0.2})) << "that of the cheapest run";
  const WorkPoint between = work_to_reach(0.01, front);
  EXPECT_NEAR(between.cost, 10, 1e-12);
  EXPECT_NEAR(between.half_range, 10 * std::sqrt(0.1 * 0.1 + 0.1 * 0.1), 1e-12) << "half of 20 % each";
  EXPECT_NEAR(work_to_reach(0.001, front).half_range, 20, 1e-12);
}

TEST(WorkPrecision, RoundsFollowTheSamePowerLaw) {
  const std::vector<WorkPoint> front{{1, 0.1, 0, {{1, 2, 0.5}, "one"}}, {100, 0.001, 0, {{100, 200, 50}, "one"}}};
  const Rounds between = work_to_reach(0.01, front).rounds;
  EXPECT_EQ(between.session, "one");
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(between.costs[k], 10 * front[0].rounds.costs[k], 1e-12);
  EXPECT_EQ(work_to_reach(0.5, front).rounds, front[0].rounds);
  EXPECT_EQ(work_to_reach(0.01, {front[0], {100, 0.001, 0, {{100, 200, 50}, "another"}}}).rounds, Rounds{});
}

TEST(WorkPrecision, AQuotientBy0MayLieAnywhere) {
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  for (const Ranged over : {Ranged{0}, Ranged{0, 1}, Ranged{1, 1}, Ranged{-1, 2}}) {
    const Estimate estimate = quotient(Ranged{3}, over);
    EXPECT_EQ(estimate.lower, -anywhere) << over.value;
    EXPECT_EQ(estimate.upper, anywhere) << over.value;
  }
  EXPECT_EQ(quotient(Ranged{3}, Ranged{-2}).lower, -1.5);
  EXPECT_EQ(quotient(Ranged{3}, Ranged{-2}).upper, -1.5);
}

TEST(WorkPrecision, Decades) {
  EXPECT_THAT(decades(0.002, 0.5), ElementsAre(0.1, 0.01));
  EXPECT_THAT(decades(0.01, 0.1), ElementsAre(0.1, 0.01));
  EXPECT_THAT(decades(0.02, 0.09), IsEmpty());
}

}  // namespace mpmvv::fits::work_precision_test
