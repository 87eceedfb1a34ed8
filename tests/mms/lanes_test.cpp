#include "mms/lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace mpmvv::mms::lanes_test {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Four units in the last place, as the vector library has it.
void expect_near(double found, double expected, double angle) {
  EXPECT_LE(std::abs(found - expected), 4 * std::numeric_limits<double>::epsilon() * std::abs(expected)) << angle;
}

TEST(Lanes, SinesAndCosinesAreThoseOfOneNumber) {
  const std::vector<Lanes> all = {{0., -0., 1e-300, 1e-9, 0.1, -0.7, 1., -1.5},
                                  {1.5707963267948966, 2., 3., -3.1415926535897931, 6.5, 100., -1e4, 1e9}};
  for (const Lanes& angles : all) {
    const Lanes sines = sin(angles), cosines = cos(angles);
    for (Eigen::Index k = 0; k < angles.size(); ++k) {
      expect_near(sines[k], std::sin(angles[k]), angles[k]);
      expect_near(cosines[k], std::cos(angles[k]), angles[k]);
    }
  }
}

TEST(Lanes, WhatIsNoAngleHasNoSine) {
  const Lanes angles{std::nan(""), infinite, -infinite, 0.5, std::nan(""), infinite, -infinite, 0.5};
  for (const Lanes& values : {sin(angles), cos(angles)})
    for (Eigen::Index k = 0; k < angles.size(); ++k) EXPECT_EQ(std::isnan(values[k]), k % 4 != 3) << k;
}

/// Bit for bit, though large angles go another way.
TEST(Lanes, NoLaneSeesTheOthers) {
  const Lanes mixed{0.3, 1e9, std::nan(""), -1.2, 0.7, infinite, 1e-300, 2.};
  for (const Eigen::Index k : {0, 3, 4, 6, 7}) {
    const Lanes alone = Lanes::Constant(mixed[k]);
    EXPECT_EQ(sin(mixed)[k], sin(alone)[0]) << k;
    EXPECT_EQ(cos(mixed)[k], cos(alone)[7]) << k;
  }
}

TEST(Lanes, EveryPointIsTakenOnce) {
  for (std::size_t count = 0; count <= 17; ++count) {
    std::vector<Vec<2>> values(count + 1, Vec<2>::Constant(-1));
    std::vector<Vec<2>> X;
    for (std::size_t k = 0; k < count; ++k) X.emplace_back(k, 2. * static_cast<double>(k));
    in_lanes<2>(X, values.data(), [](const std::array<Lanes, 2>& at) {
      return std::array<Lanes, 2>{at[0] + at[1], at[0] * at[1]};
    });
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(values[k], Vec<2>(X[k].sum(), X[k].prod())) << count;
    EXPECT_EQ(values[count], Vec<2>::Constant(-1)) << count;
  }
}

}  // namespace mpmvv::mms::lanes_test
