#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace mpmvv::solver {

namespace {

constexpr double E = 1e4, rho = 1.3, h = 0.7, dt = 2e-4;

struct State {
  double x, v, F;
};

/// One particle in one cell, held on the left, free on the right: W §3, Fig. 1.
Scene<1> one_particle(std::string_view integrator) {
  Scene<1> scene;
  scene.h = h;
  scene.cells = {1};
  scene.material = NeoHookeanLog{0, E / 2};
  scene.boundary = {Dirichlet{}, Free{}};
  scene.particles = particles_at<1>({Vec<1>(h / 2)}, h);
  scene.particles.m[0] = rho * h;
  scene.particles.v[0][0] = 5;
  scene.integrator = integrator;
  return scene;
}

/// E/2h (F² - 1) V⁰/m with the minus sign of W (14), which W (27) to (35) and (37) to (39) lack: a stretched particle
/// is pulled back.
double pull(double F) {
  return -E / (2 * h) * (F * F - 1) / rho;
}

State usf_recursion(const State& s) {  // W (34) to (36)
  const double F = (1 + s.v / h * dt) * s.F;
  return {s.x + s.v * (s.x / h) * dt + pull(F) * dt * dt, s.v + pull(F) * dt, F};
}

State usl_recursion(const State& s) {  // W (37) to (39)
  return {s.x + s.v * (s.x / h) * dt + pull(s.F) * dt * dt, s.v + pull(s.F) * dt,
          (1 + (s.v / h + pull(s.F) / s.x * dt) * dt) * s.F};
}

void expect_recursion(std::string_view integrator, State (*next)(const State&)) {
  Mpm<1> mpm(one_particle(integrator));
  const auto state = [&mpm] {
    return State{mpm.particles().x[0][0], mpm.particles().v[0][0], mpm.particles().F[0](0, 0)};
  };
  double least = 5, most = -5;
  for (int k = 0; k < 400; ++k) {
    const State expected = next(state());
    ASSERT_TRUE(mpm.step(dt));
    EXPECT_NEAR(state().x, expected.x, 1e-14);
    EXPECT_NEAR(state().v, expected.v, 1e-14 * 5);
    EXPECT_NEAR(state().F, expected.F, 1e-14);
    least = std::min(least, state().v), most = std::max(most, state().v);
  }
  EXPECT_LT(least, -4);  // it swings
  EXPECT_LT(most, 6);
}

TEST(OneParticle, FollowsTheUsfRecursion) {
  expect_recursion("usf", usf_recursion);
}
TEST(OneParticle, FollowsTheUslRecursion) {
  expect_recursion("usl", usl_recursion);
}

}  // namespace

}  // namespace mpmvv::solver
