#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

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

/// Throws when it is asked for the second time.
struct Throwing final : BodyForce<1> {
  void on_particles(double, std::span<const std::uint32_t> ids, std::span<const Vec<1>>, Vec<1>* b) const override {
    if (++asked == 2) throw std::domain_error("no force here");
    std::fill_n(b, ids.size(), Vec<1>::Zero());
  }
  Vec<1> at_position(const Vec<1>&, double) const override { return Vec<1>::Zero(); }

  mutable int asked = 0;
};

TEST(BodyForce, ThatThrowsLeavesParticlesWhereTheLastStepHasMovedThem) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 8, 1);
  for (auto& v : scene.particles.v) v[0] = 3;
  const double dt = 0.1 * scene.h / 120;
  Mpm<1> sound(scene);
  ASSERT_TRUE(sound.step(dt));
  Throwing force;
  scene.body_force = &force;
  Mpm<1> mpm(scene);
  EXPECT_THROW(mpm.advance(dt, 3), std::domain_error);  // in the visit that also moves particles
  EXPECT_EQ(mpm.particles().x, sound.particles().x);
}

TEST(BodyForce, ThatThrowsLeavesNothingOnNodes) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 100, 4, Free{});
  Throwing force;
  scene.body_force = &force;
  Mpm<1> mpm(scene);
  const double dt = 0.1 * scene.h / 120;
  EXPECT_THROW(mpm.step(dt), std::domain_error);  // after the first of several blocks has been mapped
  ASSERT_TRUE(mpm.step(dt)) << mpm.fault();
  double mass = 0;
  for (std::size_t n = 0; n < mpm.grid().size(); ++n) mass += mpm.grid().m(n);
  EXPECT_NEAR(mass, mpm.mass(), 1e-13);
}

}  // namespace mpmvv::solver::body_force_test
