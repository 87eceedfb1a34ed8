#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "studies/check.hpp"

namespace mpmvv {
namespace {

/// The mean displacement of W (56) over X in [0, 1] is A 2/π times its factor of time, cos Cπt or sin Cπt, C = 2/T.
TEST(ParticlePanel, TheSquaresParticlesFollowItsSolutionAndTheirVoxelsFillIt) {
  const CheckResult result = find_check("square-particles", "").run();
  ASSERT_EQ(result.series.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    const auto& panel = result.series[static_cast<std::size_t>(k)];
    ASSERT_EQ(panel.points.size(), 16U * 16U);
    double x = 0, y = 0, area = 0;
    for (const Point& p : panel.points) {
      x += p.x / 256, y += p.y.at("y") / 256;
      area += p.y.at("width_x") * p.y.at("width_y");
      EXPECT_GT(p.x, 0);
      EXPECT_LT(p.x, 1);
    }
    const double phase = 2 * std::numbers::pi * (2 * k + 1) / 8, largest = 0.1 * 2 / std::numbers::pi;
    EXPECT_NEAR(x, 0.5 + largest * std::cos(phase), 0.05 * largest) << panel.name;
    EXPECT_NEAR(y, 0.5 + largest * std::sin(phase), 0.05 * largest) << panel.name;
    EXPECT_NEAR(area, 1, 0.01) << panel.name;
  }
}

}  // namespace
}  // namespace mpmvv
