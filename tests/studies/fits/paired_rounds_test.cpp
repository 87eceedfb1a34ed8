#include "studies/fits/paired_rounds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace mpmvv::fits::paired_rounds_test {

double ratio(std::span<const double> costs) {
  return costs[0] / costs[1];
}

/// The logarithms of the ratios are those of 2 with 0.1, 0 and -0.1 added. Their mean has a standard error of 0.1 / √3.
TEST(PairedRounds, ARatioHasStudentsIntervalOfTheMeanOfItsLogarithms) {
  const auto costs = [](std::array<double, 3> slow) {
    return std::vector<Rounds>{{{2 * std::exp(0.1) * slow[0], 2 * slow[1], 2 * std::exp(-0.1) * slow[2]}, "one"},
                               {{slow[0], slow[1], slow[2]}, "one"}};
  };
  for (const auto& slow : {std::array{1.0, 1.0, 1.0}, {1.0, 40.0, 3.0}}) {
    const auto [value, lower, upper] = over_rounds(costs(slow), ratio);
    EXPECT_NEAR(value, 2, 1e-12);
    EXPECT_NEAR(std::log(upper / value), 4.302653 * 0.1 / std::sqrt(3), 1e-6)
        << "what slows a whole round is no matter";
    EXPECT_NEAR(value / lower, upper / value, 1e-12);
  }
}

TEST(PairedRounds, ANumberOfEitherSignHasAnIntervalAroundIt) {
  const std::vector<Rounds> rounds{{{1, 1, 4}, "one"}, {{2, 2, 2}, "one"}};
  const auto [value, lower, upper] = over_rounds(rounds, [](auto costs) { return costs[0] - costs[1]; });
  EXPECT_NEAR(value, std::cbrt(4) - 2, 1e-12);
  EXPECT_NEAR(upper - value, 4.302653 * std::sqrt(2. / 3 * (2. / 3)), 1e-5) << "0, 0 and -1 with a round left out";
  EXPECT_NEAR(value - lower, upper - value, 1e-12);
}

TEST(PairedRounds, WhereANumberIsNotFiniteItMayBeAnything) {
  const std::vector<Rounds> rounds{{{1, 1, 4}, "one"}, {{1, 1, 1}, "one"}};
  const auto [value, lower, upper] = over_rounds(rounds, [](auto costs) { return 1 / (costs[0] - costs[1]); });
  EXPECT_NEAR(value, 1 / (std::cbrt(4) - 1), 1e-12);
  EXPECT_EQ(lower, -INFINITY);
  EXPECT_EQ(upper, INFINITY);
}

TEST(PairedRounds, AreThoseOfOneSession) {
  const auto paired = [](const Rounds& a, const Rounds& b) { return are_paired(std::array{a, b}); };
  const Rounds one{{1, 2, 3}, "one"};
  EXPECT_TRUE(paired(one, {{4, 5, 6}, "one"}));
  EXPECT_FALSE(paired(one, {{4, 5, 6}, "another"}));
  EXPECT_FALSE(paired(one, {{4, 5, 6, 7}, "one"}));
  EXPECT_FALSE(paired({{1, 2}, "one"}, {{4, 5}, "one"})) << "too few";
  EXPECT_FALSE(paired({}, {}));
  EXPECT_FALSE(paired({{1, 2, 3}, ""}, {{1, 2, 3}, ""}));
  EXPECT_FALSE(are_paired({}));
}

/// The quotient of two slopes, of times that share a machine's slow spells and have outliers of their own.
TEST(PairedRounds, TheIntervalHoldsTheNumberInNineteenOfTwentySessions) {
  std::mt19937 random(4);
  std::exponential_distribution<double> noise(1 / 0.05);
  std::uniform_real_distribution<double> spell(1, 1.4);
  const std::array means{60.0, 82.0, 101.0, 104.0, 66.0, 101.0, 107.0, 130.0};
  constexpr auto slopes = [](std::span<const double> y) {
    const auto slope = [](std::span<const double> of) { return 11 * (of[3] - of[0]) + 1 * (of[2] - of[1]); };
    return slope(y.last(4)) / slope(y.first(4));
  };
  const double truth = slopes(means);
  for (const int count : {3, 5, 20}) {
    int held = 0;
    constexpr int sessions = 2000;
    for (int session = 0; session < sessions; ++session) {
      std::vector<Rounds> rounds(means.size(), {{}, "one"});
      for (int round = 0; round < count; ++round) {
        const double slow = spell(random);
        for (std::size_t k = 0; k < means.size(); ++k) rounds[k].costs.push_back(means[k] * slow * (1 + noise(random)));
      }
      const auto [value, lower, upper] = over_rounds(rounds, slopes);
      held += lower <= truth && truth <= upper ? 1 : 0;
    }
    EXPECT_NEAR(held, 0.95 * sessions, 0.02 * sessions) << count << " rounds";
  }
}

}  // namespace mpmvv::fits::paired_rounds_test
