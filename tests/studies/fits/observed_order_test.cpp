#include "studies/fits/observed_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "studies/support/error.hpp"
#include "tests/numbers.hpp"

namespace mpmvv::fits::observed_order_test {

std::vector<ErrorSample> sweep(const std::function<double(double)>& error, int levels) {
  std::vector<ErrorSample> samples;
  for (int k = 0; k < levels; ++k) {
    const double cells = 8 * std::exp2(k);
    samples.push_back({cells, 1 / cells, error(1 / cells)});
  }
  return samples;
}

TEST(ObservedOrder, IsAsymptoticWhereTheErrorFalls) {
  const auto word_of = [](double p) {
    return asymptotic_word(fit_order(sweep([p](double h) { return std::pow(h, p); }, 5), 8, 128));
  };
  EXPECT_EQ(word_of(2), "yes");
  EXPECT_EQ(word_of(0.5), "yes");
  EXPECT_EQ(word_of(0.1), "stays");
  EXPECT_EQ(word_of(-0.1), "stays");
  EXPECT_EQ(word_of(-0.7), "grows");
  EXPECT_EQ(asymptotic_word(fit_order(sweep([](double h) { return h * h + 1e-3; }, 5), 8, 128)), "no");
}

TEST(ObservedOrder, PowerLawIsRecovered) {
  for (const double p : {0.5, 1.0, 2.0, 4.0, -1.0}) {
    const auto fit = fit_order(sweep([&](double h) { return 3 * std::pow(h, p); }, 6), 8, 256);
    EXPECT_NEAR(fit.order, p, 1e-12);
    EXPECT_NEAR(fit.constant, 3, 1e-10);
    EXPECT_NEAR(fit.half_width, 0, 1e-10);
    EXPECT_NEAR(fit.r_squared, 1, 1e-12);
    EXPECT_EQ(fit.points, 6);
    EXPECT_TRUE(fit.asymptotic);
    EXPECT_EQ(fit.asymptotic_from, 8);
    EXPECT_EQ(fit.asymptotic_to, 256);
    ASSERT_EQ(fit.segments.size(), 5u);
    for (const SegmentOrder& s : fit.segments) EXPECT_NEAR(s.order, p, 1e-12);
    EXPECT_EQ(fit.segments[1].from, 16);
    EXPECT_EQ(fit.segments[1].to, 32);
  }
}

// In powers of two: line through (-2, -3.6) with slope Sxy/Sxx = 20/10, residuals -0.4, 0.6, -0.4, 0.6, -0.4.
TEST(ObservedOrder, IntervalAndRSquaredAgreeWithHandCalculation) {
  std::vector<ErrorSample> samples;
  const double y[] = {0, -1, -4, -5, -8};
  for (int k = 0; k < 5; ++k) samples.push_back({double(k), std::exp2(-k), std::exp2(y[k])});
  const auto fit = fit_order(samples, 0, 4);
  const double misfit = 3 * 0.16 + 2 * 0.36, s_xx = 10, s_yy = 41.2;
  EXPECT_NEAR(fit.order, 2, 1e-12);
  EXPECT_NEAR(fit.r_squared, 1 - misfit / s_yy, 1e-12);
  EXPECT_NEAR(fit.half_width, 3.182446305 * std::sqrt(misfit / 3 / s_xx), 1e-8);
  EXPECT_NEAR(std::log2(fit.constant), 0.4, 1e-12);
}

// docs/misprints.md, T9: the interval of a biased sequence can exclude the true order.
TEST(ObservedOrder, ReproducesTheBiasOfNumericsMd) {
  const auto cubic = fit_order(sweep([](double h) { return h * h + 5 * h * h * h; }, 5), 8, 128);
  EXPECT_NEAR(cubic.order, 2.16, 0.005);
  EXPECT_NEAR(cubic.half_width, 0.09, 0.005);
  const auto floor = fit_order(sweep([](double h) { return h * h + 1e-4; }, 5), 8, 128);
  EXPECT_NEAR(floor.order, 1.68, 0.005);
  EXPECT_NEAR(floor.half_width, 0.32, 0.005);
  EXPECT_NEAR(floor.segments.front().order, 1.97, 0.015);
  EXPECT_NEAR(floor.segments.back().order, 1.10, 0.005);
}

TEST(ObservedOrder, FitsTheDeclaredWindowAndReportsEverySegment) {
  // Order 2 down to h = 1/64, order 1 from there on.
  const auto samples = sweep([](double h) { return h > 1.0 / 64 ? h * h : h / 64; }, 7);
  const auto coarse = fit_order(samples, 8, 64);
  EXPECT_NEAR(coarse.order, 2, 1e-12);
  EXPECT_EQ(coarse.points, 4);
  EXPECT_TRUE(coarse.asymptotic);
  EXPECT_EQ(coarse.segments.size(), 6u);
  EXPECT_NEAR(fit_order(samples, 64, 512).order, 1, 1e-12);
  EXPECT_FALSE(fit_order(samples, 8, 512).asymptotic);
}

TEST(ObservedOrder, WindowIncludesItsEndsUpToRoundOff) {
  const auto samples = sweep([](double h) { return h; }, 5);
  EXPECT_EQ(fit_order(samples, 16, 64).points, 3);
  EXPECT_EQ(fit_order(samples, 16 * (1 + 5e-10), 64 * (1 - 5e-10)).points, 3);
  EXPECT_EQ(fit_order(samples, 16 * (1 + 1e-8), 64 * (1 - 1e-8)).points, 1);
}

TEST(ObservedOrder, UnusableSamplesAreLeftOut) {
  auto samples = sweep([](double h) { return h * h; }, 7);
  samples[1].e = nan;
  samples[2].e = 0;
  samples[3].e = infinity;
  samples[4].e = -1;
  const auto fit = fit_order(samples, 8, 512);
  EXPECT_EQ(fit.points, 3);
  EXPECT_NEAR(fit.order, 2, 1e-12);
  ASSERT_EQ(fit.segments.size(), 2u);
  EXPECT_EQ(fit.segments[0].from, 8);
  EXPECT_EQ(fit.segments[0].to, 256);
}

TEST(ObservedOrder, FewPointsGiveNoInterval) {
  const auto samples = sweep([](double h) { return h * h + h; }, 6);
  EXPECT_TRUE(std::isnan(fit_order(samples, 8, 32).half_width));
  EXPECT_FALSE(std::isnan(fit_order(samples, 8, 64).half_width));
  EXPECT_FALSE(std::isnan(fit_order(samples, 8, 16).order));
  EXPECT_FALSE(fit_order(samples, 8, 16).asymptotic);

  const auto one = fit_order(samples, 8, 8);
  EXPECT_EQ(one.points, 1);
  EXPECT_TRUE(std::isnan(one.order));
  EXPECT_TRUE(std::isnan(one.constant));

  const auto none = fit_order({}, 8, 64);
  EXPECT_EQ(none.points, 0);
  EXPECT_TRUE(std::isnan(none.order));
  EXPECT_TRUE(none.segments.empty());
  EXPECT_TRUE(std::isnan(none.asymptotic_from));
}

/// Segments of 1 and 2.
TEST(ObservedOrder, ThreePointsReachFromSegmentToSegment) {
  const std::vector<ErrorSample> samples = {{8, 1. / 8, 8}, {16, 1. / 16, 4}, {32, 1. / 32, 1}, {64, 1. / 64, 0.5}};
  ObservedOrder fit = fit_order(samples, 8, 32);
  EXPECT_NEAR(half_width(fit), 0.5, 1e-12);
  fit.replicates = ReplicateFit{6, 0.01, 0.125, 0.5};
  EXPECT_EQ(half_width(fit), 0.125) << "replicates know better";
  fit.replicates->half_width = not_measured;
  EXPECT_NEAR(half_width(fit), 0.5, 1e-12) << "where they know something";
  EXPECT_EQ(half_width(fit_order(samples, 8, 16)), 0) << "of two points nothing is known";
  const ObservedOrder four = fit_order(samples, 8, 64);
  EXPECT_EQ(half_width(four), four.half_width) << "by their residuals";
}

TEST(ObservedOrder, ASampleWithoutAnErrorBetweenOthersLeavesNoAsymptoticRange) {
  auto samples = sweep([](double h) { return h * h; }, 7);
  samples[3].e = nan;
  const auto fit = fit_order(samples, 8, 512);
  EXPECT_FALSE(fit.asymptotic);
  EXPECT_EQ(fit.asymptotic_from, 128);
  EXPECT_EQ(fit.asymptotic_to, 512);
  EXPECT_TRUE(fit_order(samples, 8, 32).asymptotic);
}

TEST(ObservedOrder, HasAFinestSegmentOnTheSideOfTheSmallerSteps) {
  auto samples = sweep([](double h) { return h > 1. / 64 ? h * h : h / 64; }, 6);
  EXPECT_NEAR(finest_segment(fit_order(samples, 8, 128), true), 1, 1e-12);
  EXPECT_NEAR(finest_segment(fit_order(samples, 8, 64), true), 2, 1e-12);
  EXPECT_TRUE(std::isnan(finest_segment(fit_order(samples, 8, 8), true)));
  for (ErrorSample& s : samples) s.x = s.h;
  EXPECT_NEAR(finest_segment(fit_order(samples, 1. / 128, 1. / 8), false), 1, 1e-12);
}

TEST(ObservedOrder, EqualStepSizesHaveNoOrder) {
  const std::vector<ErrorSample> samples = {{1, 0.5, 1}, {2, 0.5, 2}, {3, 0.5, 3}};
  const auto fit = fit_order(samples, 1, 3);
  EXPECT_TRUE(std::isnan(fit.order));
  EXPECT_TRUE(std::isnan(fit.segments[0].order));
  EXPECT_FALSE(fit.asymptotic);
}

TEST(ObservedOrder, OrderOfTheSamplesDoesNotMatter) {
  auto samples = sweep([](double h) { return h * h + 0.3 * h; }, 6);
  const auto sorted = fit_order(samples, 8, 256);
  std::reverse(samples.begin(), samples.end());
  std::swap(samples[1], samples[4]);
  const auto shuffled = fit_order(samples, 8, 256);
  EXPECT_EQ(shuffled.order, sorted.order);
  EXPECT_EQ(shuffled.half_width, sorted.half_width);
  EXPECT_EQ(shuffled.asymptotic_from, sorted.asymptotic_from);
  EXPECT_EQ(shuffled.segments.back().to, 256);
}

TEST(ObservedOrder, AsymptoticWindowIsFoundButNotUsed) {
  // Segments 2.31, 2.18, 2.10, 2.05: the first spoils the agreement.
  const auto samples = sweep([](double h) { return h * h + 5 * h * h * h; }, 5);
  const auto fit = fit_order(samples, 8, 128);
  EXPECT_FALSE(fit.asymptotic);
  EXPECT_EQ(fit.asymptotic_from, 16);
  EXPECT_EQ(fit.asymptotic_to, 128);
  EXPECT_EQ(fit.points, 5);
  EXPECT_TRUE(fit_order(samples, 16, 128).asymptotic);
}

TEST(ObservedOrder, OfEquallyLongAsymptoticWindowsTheFinestIsTaken) {
  const auto kinked = [](double h) { return h > 1.0 / 32 ? h * h : h / 32; };
  const auto fit = fit_order(sweep(kinked, 5), 8, 128);
  EXPECT_EQ(fit.asymptotic_from, 32);
  EXPECT_EQ(fit.asymptotic_to, 128);

  // Swept by h itself, the finest are the first.
  auto by_step = sweep(kinked, 5);
  for (ErrorSample& s : by_step) s.x = s.h;
  const auto swept_by_step = fit_order(by_step, 0, 1);
  EXPECT_EQ(swept_by_step.asymptotic_from, 1.0 / 128);
  EXPECT_EQ(swept_by_step.asymptotic_to, 1.0 / 32);
}

TEST(ObservedOrder, NoAsymptoticWindowInAFallingOrder) {
  const auto fit = fit_order(sweep([](double h) { return std::exp2(-std::pow(-std::log2(h), 1.5)); }, 5), 8, 128);
  EXPECT_FALSE(fit.asymptotic);
  EXPECT_TRUE(std::isnan(fit.asymptotic_from));
  EXPECT_TRUE(std::isnan(fit.asymptotic_to));
}

TEST(ObservedOrder, OnePerCentOfScatterStaysAsymptotic) {
  auto samples = sweep([](double h) { return h * h; }, 6);
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k].e *= k % 2 == 0 ? 1.01 : 0.99;
  EXPECT_TRUE(fit_order(samples, 8, 256).asymptotic);
}

TEST(ObservedOrder, EmptyWindowIsAnError) {
  const auto samples = sweep([](double h) { return h; }, 4);
  EXPECT_THROW(fit_order(samples, 64, 8), support::UsageError);
  EXPECT_THROW(fit_order(samples, nan, 8), support::UsageError);
  EXPECT_THROW(fit_floor(samples, 8, nan), support::UsageError);
}

}  // namespace mpmvv::fits::observed_order_test
