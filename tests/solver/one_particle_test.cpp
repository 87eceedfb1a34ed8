#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::one_particle_test {

constexpr double E = 1e4, rho = 1.3, h = 0.7;

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

State usf_recursion(const State& s, double dt) {  // W (34) to (36)
  const double F = (1 + s.v / h * dt) * s.F;
  return {s.x + s.v * (s.x / h) * dt + pull(F) * dt * dt, s.v + pull(F) * dt, F};
}

State usl_recursion(const State& s, double dt) {  // W (37) to (39)
  return {s.x + s.v * (s.x / h) * dt + pull(s.F) * dt * dt, s.v + pull(s.F) * dt,
          (1 + (s.v / h + pull(s.F) / s.x * dt) * dt) * s.F};
}

State move(const State& s, double v_plus, double pulled, double F, double dt) {
  return {s.x + v_plus * (s.x / h) * dt, s.v + pulled * dt, F};
}

/// v⁺ = v + a_i Δt with a_i = f_i/m_i and m_i = m x/h; mapped anew the updated momentum gives v + pull Δt instead.
double advanced(const State& s, double pulled, double dt) {
  return s.v + pulled * (h / s.x) * dt;
}

State usavg_recursion(const State& s, double dt) {  // N §2.3
  const double half = (1 + s.v / h * dt / 2) * s.F, kick = pull(half), v_plus = advanced(s, kick, dt);
  return move(s, v_plus, kick, (1 + v_plus / h * dt / 2) * half, dt);
}

State usl_plus_recursion(const State& s, double dt) {
  const double kick = pull(s.F);
  return move(s, advanced(s, kick, dt), kick, (1 + (s.v + kick * dt) / h * dt) * s.F, dt);
}

State usavg_plus_recursion(const State& s, double dt) {
  const double half = (1 + s.v / h * dt / 2) * s.F, kick = pull(half);
  return move(s, advanced(s, kick, dt), kick, (1 + (s.v + kick * dt) / h * dt / 2) * half, dt);
}

/// x' = v x/h, v' = pull(F), F' = v/h F: what all of them tend to.
State rk4_recursion(const State& s, double dt) {
  const auto rate = [](const State& y) { return State{y.v * y.x / h, pull(y.F), y.v / h * y.F}; };
  const auto step = [](const State& y, const State& k, double d) {
    return State{y.x + d * k.x, y.v + d * k.v, y.F + d * k.F};
  };
  const State k1 = rate(s), k2 = rate(step(s, k1, dt / 2)), k3 = rate(step(s, k2, dt / 2)), k4 = rate(step(s, k3, dt));
  return step(step(step(step(s, k1, dt / 6), k2, dt / 3), k3, dt / 3), k4, dt / 6);
}

void expect_recursion(std::string_view integrator, State (*next)(const State&, double)) {
  Mpm<1> mpm(one_particle(integrator));
  const auto state = [&mpm] {
    return State{mpm.particles().x[0][0], mpm.particles().v[0][0], mpm.particles().F[0](0, 0)};
  };
  const double dt = 2e-4;
  double least = 5, most = -5;
  for (int k = 0; k < 400; ++k) {
    const State expected = next(state(), dt);
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
TEST(OneParticle, FollowsTheUsavgRecursion) {
  expect_recursion("usavg", usavg_recursion);
}
TEST(OneParticle, FollowsTheUslPlusRecursion) {
  expect_recursion("usl+", usl_plus_recursion);
}
TEST(OneParticle, FollowsTheUsavgPlusRecursion) {
  expect_recursion("usavg+", usavg_plus_recursion);
}
TEST(OneParticle, FollowsTheRungeKuttaRecursion) {
  expect_recursion("rk4", rk4_recursion);
}

/// The state at t = 0.01 s, a bit more than a fifth of an oscillation.
State at_end(std::string_view integrator, int steps) {
  Mpm<1> mpm(one_particle(integrator));
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(mpm.step(0.01 / steps));
  return {mpm.particles().x[0][0], mpm.particles().v[0][0], mpm.particles().F[0](0, 0)};
}

double distance(const State& a, const State& b) {
  return std::max({std::abs(a.x - b.x) / h, std::abs(a.v - b.v) / 5, std::abs(a.F - b.F)});
}

double order_in_time(std::string_view integrator, int steps) {
  State limit{h / 2, 5, 1};
  for (int k = 0; k < 4096; ++k) limit = rk4_recursion(limit, 0.01 / 4096);
  return std::log2(distance(at_end(integrator, steps), limit) / distance(at_end(integrator, 2 * steps), limit));
}

/// Energy over its initial value, step by step, of a motion so small that it is harmonic: v' = -ω² h y, y' = v/h, y = F
/// - 1.
const double omega = std::sqrt(E / rho) / h;

std::vector<double> energies(std::string_view integrator, double dt, int steps) {
  Scene<1> scene = one_particle(integrator);
  scene.particles.v[0][0] = 1e-4;
  Mpm<1> mpm(scene);
  const double start = mpm.kinetic_energy();
  std::vector<double> ratios;
  for (int k = 0; k < steps; ++k) {
    EXPECT_TRUE(mpm.step(dt));
    ratios.push_back((mpm.kinetic_energy() + mpm.strain_energy()) / start);
  }
  return ratios;
}

/// With its mapped velocity usf is the symplectic Euler method, usl+ its adjoint, and usavg+ their composition,
/// leapfrog. The v⁺ of usl exceeds the mapped velocity by Δt (a_i - S⁺S a_i) = Δt v', since S⁺S = x/h = 1/2 here; so y
/// gets -ω² Δt² y more per step and the energy decays as exp(-ω² Δt t). usavg does so by half, between usf and usl.
TEST(OneParticle, UsavgLosesHalfTheEnergyThatUslLoses) {
  const int steps = 8 * 400;  // eight oscillations
  const double t = 8 * 2 * M_PI / omega, dt = t / steps;
  const double decay = omega * omega * dt * t;
  for (const auto& [integrator, share] :
       {std::pair{"usf", 0.}, {"usl", 1.}, {"usavg", 0.5}, {"usl+", 0.}, {"usavg+", 0.}})
    EXPECT_NEAR(-std::log(energies(integrator, dt, steps).back()), share * decay, 0.02 * decay) << integrator;
}

TEST(OneParticle, EnergyErrorsOfUsfAndUslPlusCancelInUsavgPlus) {
  const int steps = 400;
  const double dt = 2 * M_PI / omega / steps;
  const auto usf = energies("usf", dt, steps), usl = energies("usl+", dt, steps), usavg = energies("usavg+", dt, steps);
  double first_order = 0, sum = 0, averaged = 0;
  for (std::size_t k = 0; k < usf.size(); ++k) {
    first_order = std::max(first_order, std::abs(usf[k] - 1));
    sum = std::max(sum, std::abs(usf[k] + usl[k] - 2));
    averaged = std::max(averaged, std::abs(usavg[k] - 1));
  }
  EXPECT_NEAR(first_order, omega * dt / 2, 0.02 * omega * dt);  // the modified energy of symplectic Euler
  EXPECT_LT(sum, 3 * omega * dt * first_order);
  EXPECT_LT(averaged, 3 * omega * dt * first_order);
}

TEST(OneParticle, OrdersInTime) {
  for (const auto* integrator : {"usf", "usl", "usavg", "usl+", "usavg+"})
    EXPECT_NEAR(order_in_time(integrator, 512), 1, 0.05) << integrator;
  EXPECT_NEAR(order_in_time("rk4", 32), 4, 0.1);
}

}  // namespace mpmvv::solver::one_particle_test
