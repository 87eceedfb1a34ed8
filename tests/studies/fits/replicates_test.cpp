#include "studies/fits/replicates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace mpmvv::fits::replicates_test {

/// `count` samples at each number of cells: e(h) times exp(scatter z), z normal.
template <class Error>
std::vector<ErrorSample> sampled(const Error& e, int count, double scatter, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> z;
  std::vector<ErrorSample> samples;
  for (const double cells : {8.0, 16.0, 32.0, 64.0, 128.0})
    for (int k = 0; k < count; ++k) samples.push_back({cells, 1 / cells, e(1 / cells) * std::exp(scatter * z(random))});
  return samples;
}

double quadratic(double h) {
  return 3 * h * h;
}

TEST(Replicates, MeasureTheScatterWithinLevels) {
  const ReplicateFit fit = fit_replicates(sampled(quadratic, 40, 0.1, 1), 8, 128);
  EXPECT_EQ(fit.observations, 200);
  EXPECT_NEAR(fit.scatter, 0.1, 0.02);
}

TEST(Replicates, IntervalCoversTheSlopeNineteenTimesInTwenty) {
  int covered = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const auto samples = sampled(quadratic, 4, 0.1, seed);
    const double width = fit_replicates(samples, 8, 128).half_width;
    covered += std::abs(fit_order(samples, 8, 128).order - 2) <= width ? 1 : 0;
  }
  EXPECT_GT(covered, 365);
  EXPECT_LT(covered, 395);
}

TEST(Replicates, LackOfFitIsUniformUnderALawAndSmallWithoutOne) {
  int below = 0;
  for (unsigned seed = 0; seed < 400; ++seed)
    below += fit_replicates(sampled(quadratic, 4, 0.1, seed), 8, 128).lack_of_fit < 0.25 ? 1 : 0;
  EXPECT_NEAR(below, 100, 30);
  const auto mixed = [](double h) { return h * h + 0.02 * h; };
  EXPECT_LT(fit_replicates(sampled(mixed, 4, 0.05, 1), 8, 128).lack_of_fit, 1e-3);
}

/// With hardly any scatter a bent line would have an order of many digits.
TEST(Replicates, IntervalIsThatOfTheLineWhereTheFitIsRejected) {
  const auto mixed = [](double h) { return h * h + 0.02 * h; };
  const auto samples = sampled(mixed, 4, 1e-5, 1);
  const ReplicateFit fit = fit_replicates(samples, 8, 128);
  EXPECT_LT(fit.lack_of_fit, 1e-12);
  EXPECT_NEAR(fit.half_width, fit_order(sampled(mixed, 1, 0, 1), 8, 128).half_width, 1e-3);
  EXPECT_GT(fit.half_width, 0.1);
}

TEST(Replicates, SaysNothingWithoutThem) {
  const ReplicateFit fit = fit_replicates(sampled(quadratic, 1, 0.1, 1), 8, 128);
  EXPECT_TRUE(std::isnan(fit.half_width));
  EXPECT_TRUE(std::isnan(fit.lack_of_fit));
  EXPECT_TRUE(std::isnan(fit_replicates(sampled(quadratic, 4, 0.0, 1), 8, 128).lack_of_fit))
      << "no scatter, no measure";
  const auto mixed = [](double h) { return h * h + 0.02 * h; };
  const ReplicateFit alike = fit_replicates(sampled(mixed, 4, 0.0, 1), 8, 128);
  EXPECT_EQ(alike.lack_of_fit, 0) << "but one on a bent line";
  EXPECT_GT(alike.half_width, 0.1);
}

/// One that is left out would leave a scatter, and a slope, that are those of other data than the order's.
TEST(Replicates, SayNothingWhereOneIsNotAboveZero) {
  auto samples = sampled(quadratic, 4, 0.1, 1);
  samples[5].e = -samples[5].e;
  const ReplicateFit fit = fit_replicates(samples, 8, 128);
  EXPECT_EQ(fit.observations, 0);
  EXPECT_TRUE(std::isnan(fit.half_width));
  EXPECT_GT(fit_replicates(samples, 2 * samples[5].x, 128).half_width, 0) << "but for one beyond the window";
}

TEST(Replicates, OutsideTheWindowDoNotCount) {
  EXPECT_EQ(fit_replicates(sampled(quadratic, 3, 0.1, 1), 16, 64).observations, 9);
}

/// Logarithms 0, 1, 2: mean 1, deviation 1, t(2) = 4.303.
TEST(Replicates, HaveAGeometricMeanWithStudentsInterval) {
  const ReplicateMean mean = mean_of_replicates(std::vector{1.0, std::exp(2.0), std::exp(1.0)});
  EXPECT_NEAR(mean.value, std::exp(1.0), 1e-12);
  EXPECT_NEAR(std::log(mean.lower), 1 - 4.30265273 / std::sqrt(3.0), 1e-8);
  EXPECT_NEAR(std::log(mean.upper), 1 + 4.30265273 / std::sqrt(3.0), 1e-8);
}

TEST(Replicates, HaveAnArithmeticMeanWhereOneIsNotPositive) {
  const ReplicateMean mean = mean_of_replicates(std::vector{-1.0, 0.0, 1.0});
  EXPECT_EQ(mean.value, 0);
  EXPECT_NEAR(mean.upper, 4.30265273 / std::sqrt(3.0), 1e-8);
  EXPECT_EQ(mean.lower, -mean.upper);
  EXPECT_TRUE(std::isnan(mean_of_replicates(std::vector{2.0}).lower)) << "one value says nothing of its scatter";
  EXPECT_NEAR(mean_of_replicates(std::vector{2.0}).value, 2, 1e-15);
}

}  // namespace mpmvv::fits::replicates_test
