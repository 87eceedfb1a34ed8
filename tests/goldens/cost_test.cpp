#include "goldens/cost.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace mpmvv::goldens::cost_test {

using Random = std::mt19937;

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
  Random random_{1};
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
  EXPECT_EQ(cost_ratio(std::vector<CostPair>(8, {60, 30})).verdict(), Verdict::inconclusive);
  EXPECT_EQ(cost_ratio(std::vector<CostPair>(9, {60, 30})).verdict(), Verdict::fail);
}

/// How many of so many measurements have the verdict.
int count(Noisy noisy, int measurements, Verdict verdict) {
  int found = 0;
  for (int k = 0; k < measurements; ++k) found += measured(noisy).verdict() == verdict;
  return found;
}

/// Each of the two mistakes has a chance of 0.48 % over all looks: 19 of 4,000, give or take 4.
TEST(Cost, AtTheBoundAllLooksTogetherErrAsRarelyAsTheySay) {
  for (const Verdict mistake : {Verdict::pass, Verdict::fail})
    EXPECT_LE(count({33, 30, 0.1}, 4000, mistake), 33) << to_string(mistake);
}

TEST(Cost, AProgramBesideItselfFailsNoMoreOftenThanThat) {
  for (const double noise : {0.05, 0.2, 0.8}) EXPECT_LE(count({30, 30, noise}, 1000, Verdict::fail), 11) << noise;
}

TEST(Cost, LooksAreFew) {
  std::set<std::size_t> looks;
  Noisy close_to_it(31.5, 30, 0.07);
  for (int k = 0; k < 100; ++k) looks.insert(measured(close_to_it).pairs);
  EXPECT_THAT(looks, testing::ElementsAre(9, 15, 25, 45));
}

/// A night of twenty cases, of which each costs `ratio` of the baseline's, times as much as `spread` puts them apart.
/// Of the noises the last is six times the first.
std::vector<CostRatio> night(Random& random, double ratio, double noise, double spread = 0) {
  std::vector<CostRatio> cases;
  for (int k = 0; k < 20; ++k) {
    std::normal_distribution<> log(std::log(ratio) + spread * (k - 9.5), noise * (1 + k * 5 / 19.0));
    cases.push_back(measure_cost([&] { return CostPair{30 * std::exp(log(random)), 30}; }));
  }
  return cases;
}

TEST(MeanCost, ItsIntervalHoldsTheTrueMean) {
  Random random;
  int held = 0;
  for (int k = 0; k < 400; ++k) {
    const MeanCost mean = mean_cost(night(random, 1.04, 0.03, 0.02));
    held += mean.least <= 1.04 && 1.04 <= mean.most;
  }
  EXPECT_GE(held, 390) << "396 by its 99 %, give or take two";
}

/// Of runs by turns, a first one and then the other, whose noise is like that of the run before.
TEST(MeanCost, ItsIntervalHoldsWhereNoiseDrifts) {
  Random random;
  std::normal_distribution<> step(0, 0.1);
  double drift = 0;
  const auto cost = [&] { return 30 * std::exp(drift = 0.9 * drift + step(random)); };
  int held = 0;
  for (int k = 0; k < 200; ++k) {
    std::vector<CostRatio> cases;
    bool now_first = false;
    for (int n = 0; n < 20; ++n)
      cases.push_back(measure_cost([&] {
        now_first = !now_first;
        const double first = cost(), second = cost();
        return now_first ? CostPair{first, second} : CostPair{second, first};
      }));
    const MeanCost mean = mean_cost(cases);
    EXPECT_NE(mean.verdict(), Verdict::fail) << k;
    held += mean.least <= 1 && 1 <= mean.most;
  }
  EXPECT_GE(held, 192) << "198 by its 99 %, give or take 1.4; a few fewer, as turns are not independent";
}

/// By hand: the mean of -3 to 3, and the squares of -3, -3, -2 to 2, 3 and 3 over 7 times 6.
TEST(MeanCost, IsTheOneOfTukeyAndMcLaughlin) {
  std::vector<CostPair> pairs;
  for (int k = -4; k <= 4; ++k) pairs.push_back({30 * std::exp(0.01 * k), 30});
  const MeanCost mean = mean_cost({cost_ratio(pairs)});
  EXPECT_NEAR(mean.ratio, 1, 1e-12);
  EXPECT_NEAR(std::log(mean.most), 3.7074 * 0.01 * std::sqrt(46.0 / 42), 1e-6);
  EXPECT_NEAR(std::log(mean.least), -std::log(mean.most), 1e-12);
}

TEST(MeanCost, MoreCasesNarrowIt) {
  std::vector<CostPair> pairs;
  for (int k = -4; k <= 4; ++k) pairs.push_back({30 * std::exp(0.01 * k), 30});
  const MeanCost mean = mean_cost(std::vector<CostRatio>(25, cost_ratio(pairs)));
  EXPECT_NEAR(std::log(mean.most), 2.609 * 0.01 * std::sqrt(46.0 / 42 / 25), 1e-5) << "t of 150 degrees of freedom";
}

TEST(MeanCost, SeesWhatNoCaseShows) {
  Random random;
  const auto slower = night(random, 1.05, 0.01);
  EXPECT_TRUE(std::ranges::none_of(slower, [](const CostRatio& c) { return c.verdict() == Verdict::fail; }));
  EXPECT_EQ(mean_cost(slower).verdict(), Verdict::fail);
  EXPECT_NEAR(mean_cost(slower).ratio, 1.05, 0.01);
  EXPECT_EQ(mean_cost(night(random, 1, 0.01)).verdict(), Verdict::pass);
  EXPECT_EQ(mean_cost(night(random, mean_cost_band, 0.01)).verdict(), Verdict::inconclusive);
}

TEST(MeanCost, AProgramBesideItselfDoesNotFail) {
  Random random;
  for (int k = 0; k < 300; ++k) ASSERT_NE(mean_cost(night(random, 1, 0.08)).verdict(), Verdict::fail) << k;
}

TEST(CostVerdict, IsTheWorstOfTheCasesAndTheirMean) {
  const auto all = [](std::vector<double> ratios) {
    std::vector<CostRatio> cases;
    for (const double ratio : ratios) cases.push_back(cost_ratio(std::vector<CostPair>(9, {30 * ratio, 30})));
    return cases;
  };
  EXPECT_EQ(verdict_of({}), Verdict::inconclusive);
  EXPECT_EQ(verdict_of(all({1, 1.05})), Verdict::pass);
  EXPECT_EQ(verdict_of(all({1, 1.08})), Verdict::fail) << "the mean";
  EXPECT_EQ(verdict_of(all({0.5, 1.2})), Verdict::fail) << "a case";
  std::vector<CostRatio> cases = all({0.5, 0.9});
  cases[1].most = 1.2;
  EXPECT_EQ(verdict_of(cases), Verdict::inconclusive);
  cases[0].least = cases[0].most = 1.2;
  EXPECT_EQ(verdict_of(cases), Verdict::fail);
}

TEST(MeanCost, DisturbedRunsDecideNothing) {
  std::vector<CostPair> pairs(9, {30, 30});
  pairs[3] = {300, 30}, pairs[7] = {30, 90};
  const MeanCost mean = mean_cost(std::vector<CostRatio>(20, cost_ratio(pairs)));
  EXPECT_EQ(mean.least, 1);
  EXPECT_EQ(mean.most, 1);
}

}  // namespace mpmvv::goldens::cost_test
