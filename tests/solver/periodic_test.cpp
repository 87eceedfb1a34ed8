#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::periodic_test {

/// However far a body moves in a step, it is back in the domain, as a whole.
TEST(PeriodicFaces, BringBackABodyThatMovesManyPeriodsAStep) {
  for (const double periods : {0.9, 1.9, 7.3, -0.9, -1.9, -7.3}) {
    Scene<2> scene = full_scene<2>(BSpline2{}, 6, 2);
    scene.material = NeoHookeanLog{1e-6, 1e-6};  // waves of less than a cell a step
    for (auto& v : scene.particles.v) v = Vec<2>(periods, -2 * periods);
    Mpm<2> mpm(scene);
    for (int k = 1; k <= 20; ++k) {
      ASSERT_TRUE(mpm.step(1)) << mpm.fault();
      for (std::size_t p = 0; p < mpm.particles().size(); ++p) {
        const Vec<2>& x = mpm.particles().x[p];
        ASSERT_TRUE((x.array() >= 0).all() && (x.array() < 1).all()) << x;
        const Vec<2> off = x - scene.particles.x[mpm.particles().id[p]] - k * Vec<2>(periods, -2 * periods);
        for (const double along : {off[0], off[1]}) ASSERT_NEAR(along, std::round(along), 1e-12) << periods << " " << k;
      }
    }
    EXPECT_TRUE(mpm.check()) << mpm.fault();
  }
}

/// Less than round-off below the lower face: a period further is the upper face, which is the lower one.
TEST(PeriodicFaces, BringBackToBelowTheUpperFace) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 6, 2);
  scene.particles = particles_at<1>({Vec<1>(0.0)}, scene.h);
  scene.particles.v[0][0] = -1e-20;
  Mpm<1> mpm(scene);
  ASSERT_TRUE(mpm.step(1)) << mpm.fault();
  EXPECT_EQ(mpm.particles().x[0][0], 0);
}

}  // namespace mpmvv::solver::periodic_test
