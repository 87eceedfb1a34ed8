#include "goldens/cost.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mpmvv::goldens::cost_test {

/// Pairs whose noise has a median of one.
class Noisy {
 public:
  Noisy(double now, double baseline, double noise) : now_(now), baseline_(baseline), noise_(0, noise) {}
  CostPair operator()() {
    ++measured;
    return {now_ * std::exp(noise_(random_)), baseline_ * std::exp(noise_(random_))};
  }
  int measured = 0;

 private:
  double now_, baseline_;
  std::mt19937 random_{1};
  std::normal_distribution<> noise_;
};

CostRatio measured(Noisy& noisy) {
  return measure_cost([&] { return noisy(); });
}

TEST(Cost, IsThatOfTheBaselineOrNot) {
  Noisy same(30, 30, 0.02), slower(36, 30, 0.02), faster(20, 30, 0.02);
  EXPECT_EQ(measured(same).verdict(), Verdict::pass);
  EXPECT_EQ(measured(slower).verdict(), Verdict::fail);
  EXPECT_EQ(measured(faster).verdict(), Verdict::pass);
  EXPECT_NEAR(measured(slower).ratio, 1.2, 0.03);
  EXPECT_EQ(same.measured, 9);
}

TEST(Cost, IsMeasuredAgainWhileNoiseHidesIt) {
  Noisy same(30, 30, 0.08), slower(45, 30, 0.15), at_the_bound(33, 30, 0.15);
  EXPECT_EQ(measured(same).verdict(), Verdict::pass);
  EXPECT_GT(same.measured, 9);
  EXPECT_EQ(measured(slower).verdict(), Verdict::fail);
  EXPECT_EQ(measured(at_the_bound).verdict(), Verdict::inconclusive);
  EXPECT_EQ(at_the_bound.measured, 45);
}

TEST(Cost, OneDisturbedRunDecidesNothing) {
  std::vector<CostPair> pairs(17, {30, 30});
  pairs[3] = {300, 30};
  const CostRatio cost = cost_ratio(pairs);
  EXPECT_EQ(cost.verdict(), Verdict::pass);
  EXPECT_EQ(cost.most, 1);
}

TEST(Cost, FewPairsProveNothing) {
  EXPECT_EQ(cost_ratio(std::vector<CostPair>(7, {60, 30})).verdict(), Verdict::inconclusive);
  EXPECT_EQ(cost_ratio(std::vector<CostPair>(8, {60, 30})).verdict(), Verdict::fail);
}

/// Its 99 % interval holds the true ratio as often as it says.
TEST(Cost, TheIntervalHoldsTheTrueRatio) {
  Noisy noisy(30, 30, 0.1);
  int held = 0;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    std::vector<CostPair> pairs;
    for (int k = 0; k < 15; ++k) pairs.push_back(noisy());
    const CostRatio cost = cost_ratio(pairs);
    held += cost.least <= 1 && 1 <= cost.most;
  }
  EXPECT_GE(held, 1975);
}

}  // namespace mpmvv::goldens::cost_test
