#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/solver/scenes.hpp"

/// What a material with a history is at the time of x and F, and how it starts.
namespace mpmvv::solver::thermal_state_test {

constexpr double time_step = 2e-4;

/// A wave in a periodic bar of a material with a history, with a wave speed of about 100.
Scene<1> wave_with_history(std::string_view integrator) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 10, 2);
  scene.material = MieGruneisen{1, 9000, 1.44, 2, 440, 300, 0.4, 4};
  scene.integrator = integrator;
  set_wave(scene, 5);
  return scene;
}

Mpm<1> after_steps(const Scene<1>& scene, int steps) {
  Mpm<1> mpm(scene);
  EXPECT_EQ(mpm.advance(time_step, steps), steps) << mpm.fault();
  return mpm;
}

/// The states that the particles keep, or those at the time of F, in the order of creation.
Array<ThermalState> kept(const Mpm<1>& mpm) {
  Array<ThermalState> states(mpm.particles().size());
  for (std::size_t p = 0; p < states.size(); ++p) states[mpm.particles().id[p]] = mpm.particles().thermal[p];
  return states;
}

Array<ThermalState> current(const Mpm<1>& mpm) {
  Array<ThermalState> states(mpm.particles().size());
  for (std::size_t p = 0; p < states.size(); ++p) states[mpm.particles().id[p]] = mpm.thermal_state(p);
  return states;
}

constexpr std::array with_history{"usl", "usl+", "cd", "uvf", "usavg", "usavg+", "usf"};

TEST(ThermalStates, AreThoseOfTheCurrentDeformation) {
  for (const std::string_view integrator : with_history)
    for (const int steps : {0, 1, 7}) {
      SCOPED_TRACE(std::string(integrator) + ", step " + std::to_string(steps));
      const Mpm<1> mpm = after_steps(wave_with_history(integrator), steps);
      double energy = 0;
      for (std::size_t p = 0; p < mpm.particles().size(); ++p) {
        const ThermalState state = mpm.thermal_state(p);
        EXPECT_NEAR(state.J, mpm.particles().F[p].determinant(), 1e-14);
        EXPECT_EQ(mpm.stress(p)(0, 0), -state.total_pressure());
        energy += mpm.particles().m[p] * state.energy;
      }
      EXPECT_DOUBLE_EQ(mpm.strain_energy(), energy);
    }
}

TEST(ThermalStates, AreThoseThatTheNextStepMaps) {  // where it maps the stress before F changes
  for (const std::string_view integrator : {"usl", "usl+", "cd", "uvf"}) {
    SCOPED_TRACE(integrator);
    Mpm<1> mpm = after_steps(wave_with_history(integrator), 7);
    const auto before = kept(mpm), read = current(mpm);
    ASSERT_TRUE(mpm.step(time_step));
    const auto mapped = kept(mpm);
    double largest = 0;
    for (std::size_t k = 0; k < read.size(); ++k) {
      EXPECT_NEAR(read[k].pressure, mapped[k].pressure, 1e-9);
      EXPECT_NEAR(read[k].viscous, mapped[k].viscous, 1e-9);
      EXPECT_NEAR(read[k].energy, mapped[k].energy, 1e-11);
      EXPECT_NEAR(read[k].temperature, mapped[k].temperature, 1e-9);
      largest = std::max(largest, std::abs(read[k].total_pressure() - before[k].total_pressure()));
    }
    EXPECT_GT(largest, 1);
  }
}

/// q by the time over which F has changed, which is half a step for `usavg` and `usavg+`: about that of the step
/// before.
TEST(ThermalStates, ViscosityIsByTheTimeSinceTheLastStress) {
  for (const std::string_view integrator : with_history) {
    const Mpm<1> mpm = after_steps(wave_with_history(integrator), 7);
    const auto old = kept(mpm), now = current(mpm);
    const auto most = [](const auto& states) { return std::ranges::max(states, {}, &ThermalState::viscous).viscous; };
    EXPECT_GT(most(old), 50) << integrator;
    EXPECT_NEAR(most(now) / most(old), 1, 0.2) << integrator;
  }
}

TEST(ThermalStates, OnlyMaterialsWithAHistoryHaveThem) {
  EXPECT_THROW(Mpm<1>(full_scene<1>(BSpline2{}, 10, 2)).thermal_state(0), std::invalid_argument);
}

TEST(ThermalStates, ABodyThatStartsDeformedWasDeformedSlowly) {
  for (const double J : {0.9, 1.1}) {
    Scene<1> scene = wave_with_history("usl");
    for (auto& F : scene.particles.F) F(0, 0) = J;
    const auto stress_of_step = [&scene](double dt) {
      Mpm<1> mpm(scene);
      EXPECT_TRUE(mpm.step(dt));
      return kept(mpm)[0];
    };
    const ThermalState state = stress_of_step(1e-4), same = stress_of_step(1e-7);
    EXPECT_NEAR(state.total_pressure(), same.total_pressure(), 1e-6);
    EXPECT_NEAR(state.energy, same.energy, 1e-9);
    EXPECT_NEAR(state.viscous, 0, 1e-6);
    EXPECT_NEAR(state.temperature, 300 * std::exp(2 * (1 - J)), 1e-3);  // T = T₀ exp(γ₀ η) on the isentrope
    const Mpm<1> at_start(scene);
    EXPECT_NEAR(at_start.stress(0)(0, 0), -state.pressure, 1e-6);
  }
}

TEST(MapAcceleration, RefusesAMaterialWithAHistory) {
  Mpm<1> mpm(wave_with_history("usl"));
  EXPECT_THROW(mpm.map_acceleration(), std::invalid_argument);
}

TEST(MapAcceleration, DoesNotChangeAFollowingStep) {
  for (const std::string_view integrator : integrator_words()) {
    Scene<1> scene = full_scene<1>(BSpline2{}, 10, 2);
    scene.integrator = integrator;
    set_wave(scene, 5);
    Mpm<1> watched(scene), alone(scene);
    for (int k = 0; k < 5; ++k) {
      watched.map_acceleration();
      ASSERT_TRUE(watched.step(time_step) && alone.step(time_step));
    }
    EXPECT_TRUE(watched.particles().x == alone.particles().x) << integrator;
    EXPECT_TRUE(watched.particles().v == alone.particles().v) << integrator;
    EXPECT_TRUE(watched.particles().F == alone.particles().F) << integrator;
  }
}

TEST(MapAcceleration, DoesNotHalveAtAHalfStart) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 10, 2);
  for (std::size_t p = 0; p < scene.particles.size(); ++p)
    scene.particles.F[p](0, 0) = 1 + 0.1 * std::sin(2 * M_PI * scene.particles.x[p][0]);
  scene.integrator = "cd";
  Mpm<1> whole(scene);
  scene.half_start = true;
  Mpm<1> half(scene);
  whole.map_acceleration();
  half.map_acceleration();
  double largest = 0;
  for (std::size_t n = 0; n < whole.grid().size(); ++n) {
    EXPECT_EQ(half.grid().a[n][0], whole.grid().a[n][0]);
    largest = std::max(largest, whole.grid().a[n][0]);
  }
  EXPECT_GT(largest, 100);
}

}  // namespace mpmvv::solver::thermal_state_test
