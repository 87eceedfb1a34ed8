#include "solver/simd/pack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace mpmvv::solver::four_test {

/// The error of ln x in units in the last place of the exact one.
double error_of_log(double x) {
  const double found = log(Pack(Double4{1.5, x, 0.7, 1}))[1];
  const long double exact = std::log(static_cast<long double>(x));
  if (exact == 0) return found == 0 ? 0 : std::numeric_limits<double>::infinity();
  return std::abs(static_cast<double>(found - exact)) / std::ldexp(1, std::ilogb(static_cast<double>(exact)) - 52);
}

TEST(Fours, StopBelowAWholeNumber) {
  for (int n = 1; n < 5000; ++n) EXPECT_EQ(next_below(n), std::nextafter(n, 0.0)) << n;
  for (const double n : {1e6, 123456789., 2147483647., 4294967296.}) EXPECT_EQ(next_below(n), std::nextafter(n, 0.0));
}

TEST(Fours, TakeLogarithmsToAboutOneUnitInTheLastPlace) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> some(-1, 1);
  double worst = 0;
  for (int k = 0; k < 100'000; ++k) {
    worst = std::max(worst, error_of_log(std::exp2(some(random))));
    worst = std::max(worst, error_of_log(1 + std::ldexp(some(random), -1 - k % 50)));
    worst = std::max(worst, error_of_log(std::exp2(100 * some(random))));
  }
  EXPECT_LT(worst, 1.5);
}

TEST(Fours, TakeLogarithmsOfOneAndOfWhatHasNone) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Pack found = log(Pack(Double4{1, 0, infinity, -1}));
  EXPECT_EQ(found[0], 0);
  EXPECT_EQ(found[1], -infinity);
  EXPECT_EQ(found[2], infinity);
  EXPECT_TRUE(std::isnan(found[3]));
  EXPECT_TRUE(std::isnan(log(Pack(std::nan("")))[0]));
  for (const double bound : {0.5, 2.0}) EXPECT_LT(error_of_log(bound), 1);
}

TEST(Fours, KnowWhetherAllOrAnyAreTrue) {
  for (int mask = 0; mask < 16; ++mask) {
    Mask4 truths{};
    for (int lane = 0; lane < 4; ++lane) truths[lane] = (mask >> lane & 1) ? -1 : 0;
    EXPECT_EQ(all(truths), mask == 15);
    EXPECT_EQ(any(truths), mask != 0);
  }
}

}  // namespace mpmvv::solver::four_test
