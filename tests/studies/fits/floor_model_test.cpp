#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <tuple>

#include "studies/fits/observed_order.hpp"

namespace mpmvv::fits::floor_model_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;

using Law = std::function<double(double)>;
constexpr double everywhere = std::numeric_limits<double>::infinity();

/// h = 1/8, 1/16, ...; the errors are shifted by up to the relative `scatter`, in one of two fixed patterns.
std::vector<ErrorSample> sweep(const Law& error, int levels, double scatter = 0, int pattern = 0, double coarsest = 8) {
  constexpr double signs[] = {1, -1, 1, 1, -1, -1, 1, -1};
  std::vector<ErrorSample> samples;
  for (int k = 0; k < levels; ++k) {
    const double cells = coarsest * std::exp2(k);
    const double shift = pattern == 0 ? signs[k % 8] : std::cos(7 * k * k + 1);
    samples.push_back({cells, 1 / cells, error(1 / cells) * (1 + scatter * shift)});
  }
  return samples;
}

FloorFit fit(const std::vector<ErrorSample>& samples) {
  return fit_floor(samples, -everywhere, everywhere);
}

double true_floor(double h) {
  return h * h + 1e-4;
}

class FloorModel : public ::testing::TestWithParam<std::tuple<int, double, int>> {
 protected:
  FloorFit fit_of(const Law& error) const {
    const auto [levels, scatter, pattern] = GetParam();
    return fit(sweep(error, levels, scatter, pattern));
  }
  bool exact() const { return std::get<1>(GetParam()) == 0; }
};

INSTANTIATE_TEST_SUITE_P(LevelsAndScatter, FloorModel,
                         ::testing::Combine(::testing::Values(6, 7, 8), ::testing::Values(0.0, 0.01),
                                            ::testing::Values(0, 1)));

TEST_P(FloorModel, AcceptsATrueFloor) {
  const FloorFit f = fit_of(true_floor);
  EXPECT_TRUE(f.accepted) << f.reason;
  EXPECT_THAT(f.reason, StartsWith("accepted"));
  EXPECT_NEAR(f.order, 2, exact() ? 1e-5 : 0.02);
  EXPECT_NEAR(f.floor, 1e-4, exact() ? 1e-9 : 3e-6);
  EXPECT_NEAR(f.constant, 1, exact() ? 1e-4 : 0.06);
  EXPECT_LE(f.residual, exact() ? 1e-6 : 0.01);
}

TEST_P(FloorModel, RejectsALinearTermThatFakesAFloor) {
  const FloorFit f = fit_of([](double h) { return h * h + 0.05 * h; });
  EXPECT_FALSE(f.accepted) << f.reason;
  EXPECT_GT(f.floor, 2e-5) << "the trap is there: the fit does see a floor";
}

TEST_P(FloorModel, RejectsACubicTerm) {
  EXPECT_FALSE(fit_of([](double h) { return h * h + 5 * h * h * h; }).accepted);
}

TEST_P(FloorModel, RejectsAPurePowerLaw) {
  for (const double p : {1.0, 2.0, 3.0}) {
    const FloorFit f = fit_of([p](double h) { return std::pow(h, p); });
    EXPECT_FALSE(f.accepted);
    EXPECT_THAT(f.reason, HasSubstr("of the finest error"));
    EXPECT_NEAR(f.order, p, exact() ? 1e-6 : 0.02);
  }
}

TEST_P(FloorModel, RejectsNoise) {
  for (const double size : {0.2, 0.5})
    for (unsigned seed = 0; seed < 50; ++seed) {
      std::mt19937 random(seed);
      const auto noise = [&] { return std::exp(size * (static_cast<double>(random()) / std::exp2(31) - 1)); };
      EXPECT_FALSE(fit_of([&](double h) { return h * h * noise(); }).accepted) << size << ' ' << seed;
      EXPECT_FALSE(fit_of([&](double) { return noise(); }).accepted) << size << ' ' << seed;
    }
}

TEST_P(FloorModel, RejectsAConstantAndAGrowingError) {
  EXPECT_FALSE(fit_of([](double) { return 1e-4; }).accepted);
  EXPECT_FALSE(fit_of([](double h) { return 1e-6 / h; }).accepted);
  EXPECT_FALSE(fit_of([](double h) { return h * h + 1e-6 / h; }).accepted);
}

TEST_P(FloorModel, RejectsEverySumOfTwoPowers) {
  const double powers[][2] = {{1, 0.5}, {2, 0.5}, {2, 1}, {2, 1.5}, {3, 1}, {3, 2}, {4, 1}, {4, 2}, {4, 3}};
  for (const auto& [p, q] : powers)
    for (int k = -16; k <= 8; ++k) {
      const FloorFit f = fit_of([=](double h) { return std::pow(h, p) + std::exp2(k) * std::pow(h, q); });
      EXPECT_FALSE(f.accepted) << "h^" << p << " + 2^" << k << " h^" << q << ": " << f.reason;
    }
}

TEST(FloorFit, EveryTestCanReject) {
  const auto reason = [](const std::vector<ErrorSample>& s) { return fit(s).reason; };
  EXPECT_THAT(reason(sweep([](double h) { return h * h + 1e-6; }, 6)), HasSubstr("of the finest error"));
  EXPECT_THAT(reason(sweep(true_floor, 7, 0.2)), HasSubstr("at most 0.05 allowed"));
  EXPECT_THAT(reason(sweep([](double h) { return h * h + std::exp2(-6) * std::sqrt(h); }, 6, 0, 0, 1)),
              HasSubstr("without the finest level"));
  EXPECT_THAT(reason(sweep([](double) { return 1; }, 6, 0.01)), HasSubstr("not clearly below"));
  auto outlier = sweep([](double) { return 1; }, 6);
  outlier.front().e = 2;
  EXPECT_THAT(reason(outlier), HasSubstr("end of the range"));
}

TEST(FloorFit, NeitherTermIsNegative) {
  const FloorFit below = fit(sweep([](double h) { return h * h - 5e-6; }, 6));
  EXPECT_EQ(below.floor, 0);
  EXPECT_GT(below.constant, 0);
  const FloorFit falling = fit(sweep([](double h) { return 1e-4 - 1e-4 * h; }, 6));
  EXPECT_EQ(falling.constant, 0);
  EXPECT_GT(falling.floor, 0);
}

TEST(FloorFit, NeedsSixUsablePointsInTheWindow) {
  const auto samples = sweep(true_floor, 8);
  const FloorFit five = fit_floor(samples, 8, 128);
  EXPECT_FALSE(five.accepted);
  EXPECT_TRUE(std::isnan(five.floor));
  EXPECT_THAT(five.reason, HasSubstr("5 usable points"));
  EXPECT_TRUE(fit_floor(samples, 8, 256).accepted);

  auto with_gap = sweep(true_floor, 6);
  with_gap[2].e = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fit(with_gap).accepted);
}

TEST(FloorFit, OrderOfTheSamplesAndUnitsDoNotMatter) {
  const FloorFit f = fit(sweep(true_floor, 7, 0.01));
  auto scaled = sweep(true_floor, 7, 0.01);
  for (ErrorSample& s : scaled) s = {-s.x, s.h * 1e3, s.e * 1e-6};
  const FloorFit g = fit(scaled);
  EXPECT_TRUE(g.accepted) << g.reason;
  EXPECT_NEAR(g.order, f.order, 1e-5);
  EXPECT_NEAR(g.floor, f.floor * 1e-6, 1e-15);
  EXPECT_NEAR(g.residual, f.residual, 1e-9);
}

TEST(FloorFit, IsTheMinimumOfTheRelativeMisfit) {
  const auto samples = sweep(true_floor, 7, 0.03);
  const FloorFit f = fit(samples);
  const auto misfit = [&](double p, double c, double floor) {
    double sum = 0;
    for (const ErrorSample& s : samples) sum += std::pow((c * std::pow(s.h, p) + floor) / s.e - 1, 2);
    return std::sqrt(sum / static_cast<double>(samples.size()));
  };
  EXPECT_NEAR(misfit(f.order, f.constant, f.floor), f.residual, 1e-12);
  for (const double d : {-1e-2, -1e-3, 1e-3, 1e-2}) {
    EXPECT_GT(misfit(f.order + d, f.constant, f.floor), f.residual);
    EXPECT_GT(misfit(f.order, f.constant * (1 + d), f.floor), f.residual);
    EXPECT_GT(misfit(f.order, f.constant, f.floor * (1 + d)), f.residual);
  }
}

}  // namespace mpmvv::fits::floor_model_test
