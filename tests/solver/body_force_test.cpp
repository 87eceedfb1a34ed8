#include <gtest/gtest.h>

#include <atomic>

#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::body_force_test {

/// Counts the particles asked for, and those whose reference position is not that of their id.
struct Watching final : BodyForce<2> {
  explicit Watching(Array<Vec<2>> X) : places(std::move(X)) {}

  void on_particles(double, std::span<const std::uint32_t> ids, std::span<const Vec<2>> X, Vec<2>* b) const override {
    for (std::size_t k = 0; k < ids.size(); ++k) {
      b[k].setZero();
      ++asked;
      if (X.size() != ids.size() || X[k] != places[ids[k]]) ++wrong;
    }
  }
  Vec<2> at_position(const Vec<2>&, double) const override { return Vec<2>::Zero(); }

  Array<Vec<2>> places;
  mutable std::atomic<std::size_t> asked{0}, wrong{0};
};

TEST(BodyForce, HasTheReferencePositionsOfItsParticlesThroughSorts) {
  Scene<2> scene = full_scene<2>(BSpline2{}, 24, 2);
  set_wave(scene, 5);
  for (auto& v : scene.particles.v) v.array() += 90;
  scene.particles.X = scene.particles.x;
  scene.threads = 2;
  Watching force(scene.particles.X);
  scene.body_force = &force;
  Mpm<2> mpm(scene);
  const auto first = mpm.particles().id;
  for (int k = 0; k < 40; ++k) ASSERT_TRUE(mpm.step(0.2 * scene.h / 120)) << mpm.fault();
  EXPECT_NE(mpm.particles().id, first);
  EXPECT_EQ(force.asked, 40 * first.size());
  EXPECT_EQ(force.wrong, 0U);
}

}  // namespace mpmvv::solver::body_force_test
