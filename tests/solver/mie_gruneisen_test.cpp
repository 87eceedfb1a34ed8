#include "solver/material/mie_gruneisen.hpp"

#include <gtest/gtest.h>

#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::mie_gruneisen_test {

/// Nickel as in N §3.5.
MieGruneisen nickel(double A1 = 0, double A2 = 0) {
  return {8870, 188e9, 1.44, 2, 440, 300, A1, A2};
}

/// A state brought from rest to the volume ratio J in so many equal steps.
ThermalState compressed(const MieGruneisen& material, double J, int steps, double dt = 1e-9) {
  ThermalState state = material.state_at_rest();
  for (int k = 1; k <= steps; ++k) material.advance(state, 1 + (J - 1) * k / steps, {dt, 1e-4});
  return state;
}

TEST(MieGruneisen, HasTheHugoniotItIsMadeFrom) {  // p = ρ₀ U_s u, η = u/U_s, e = u²/2 with U_s = c₀ + S₁ u
  const MieGruneisen material = nickel();
  for (const double u : {1.0, 100.0, 1840.0, 3000.0}) {
    const double U = std::sqrt(material.bulk_modulus / material.density) + material.hugoniot_slope * u;
    const double p = material.cold_pressure(u / U) + material.gamma * material.density * u * u / 2;
    EXPECT_NEAR(p / (material.density * U * u), 1, 1e-13);
  }
}

TEST(MieGruneisen, SlopeAndWaveSpeedAreDerivatives) {
  const MieGruneisen material = nickel();
  const double step = 1e-6;
  for (const double J : {1.2, 0.95, 0.8, 0.7}) {
    const double eta = 1 - J;
    const double slope = (material.cold_pressure(eta + step) - material.cold_pressure(eta - step)) / (2 * step);
    EXPECT_NEAR(material.cold_slope(eta) / slope, 1, 1e-8);
    ThermalState state = compressed(material, J, 1000), next = state;
    material.advance(next, J - step, {1e-9, 1e-4});
    const double rate_of_density = material.density / (J - step) - material.density / J;
    EXPECT_NEAR(std::pow(material.wave_speed(state), 2) * rate_of_density / (next.pressure - state.pressure), 1, 2e-5);
  }
}

TEST(MieGruneisen, SlowCompressionIsIsentropic) {  // ρ₀ de = -p dJ, T = T₀ exp(γ₀ η); of second order in the steps
  const MieGruneisen material = nickel();
  const double J = 0.75;
  const ThermalState fine = compressed(material, J, 4000), coarse = compressed(material, J, 40),
                     middle = compressed(material, J, 80);
  EXPECT_NEAR(fine.temperature, 300 * std::exp(2 * 0.25), 1e-4);
  EXPECT_NEAR((coarse.energy - fine.energy) / (middle.energy - fine.energy), 4, 0.05);
  EXPECT_NEAR((coarse.pressure - fine.pressure) / (middle.pressure - fine.pressure), 4, 0.05);
  const ThermalState back = [&] {
    ThermalState state = fine;
    for (int k = 1; k <= 4000; ++k) material.advance(state, J + (1 - J) * k / 4000, {1e-9, 1e-4});
    return state;
  }();
  EXPECT_NEAR(back.energy / fine.energy, 0, 1e-6);
  EXPECT_NEAR(back.temperature, 300, 1e-4);
}

TEST(MieGruneisen, StateAtAVolumeRatioIsOnTheIsentrope) {
  for (const double J : {0.75, 1.1}) {
    const ThermalState fine = compressed(nickel(), J, 4000), state = nickel(0.4, 4).state_at(J);
    EXPECT_EQ(state.J, J);
    EXPECT_EQ(state.viscous, 0);
    EXPECT_NEAR(state.energy / fine.energy, 1, 1e-4);
    EXPECT_NEAR(state.pressure / fine.pressure, 1, 2e-5);
    EXPECT_NEAR(state.temperature / fine.temperature, 1, 2e-6);
  }
  EXPECT_EQ(nickel().state_at(1).energy, 0);
}

TEST(MieGruneisen, ViscosityResistsCompressionAndHeats) {
  const MieGruneisen material = nickel(0.4, 4);
  const StressStep step{1e-9, 1e-4};
  ThermalState state = compressed(nickel(), 0.9, 1000), loosened = state;
  const double c = material.wave_speed(state), rate = 1e-4 * 0.01 / (0.895 * 1e-9);
  EXPECT_NEAR(material.viscous_pressure(state, 0.01, step), 8870 / 0.895 * rate * (0.4 * c + 4 * rate), 1);
  EXPECT_EQ(material.viscous_pressure(state, -0.01, step), 0);
  material.advance(loosened, 0.91, step);
  EXPECT_EQ(loosened.viscous, 0);
  ThermalState plain = state;
  nickel().advance(plain, 0.89, step);
  material.advance(state, 0.89, step);
  EXPECT_GT(state.viscous, 0);
  EXPECT_GT(state.energy, plain.energy);
  EXPECT_GT(state.temperature, plain.temperature);
}

/// ρ₀ Δe = -(p + q) ΔJ with the mean of p over the step, and the new pressure is that of the new energy.
TEST(MieGruneisen, WorkOfBothPressuresBecomesEnergy) {
  const MieGruneisen material = nickel(0.4, 4);
  for (const double J : {0.89, 0.91}) {
    const ThermalState before = compressed(nickel(), 0.9, 1000);
    ThermalState after = before;
    material.advance(after, J, {1e-9, 1e-4});
    const double work = (0.5 * (before.pressure + after.pressure) + after.viscous) * (before.J - J);
    EXPECT_NEAR(material.density * (after.energy - before.energy) / work, 1, 1e-10) << J;
    const double of_state = material.cold_pressure(1 - J) + material.gamma * material.density * after.energy;
    EXPECT_NEAR(after.pressure / of_state, 1, 1e-12) << J;
  }
}

TEST(MieGruneisen, EndsAtTheHugoniotsPole) {
  EXPECT_TRUE(std::isfinite(nickel().cold_pressure(0.99 / 1.44)));
  EXPECT_FALSE(std::isfinite(nickel().cold_pressure(1.01 / 1.44)));
  EXPECT_FALSE(std::isfinite(compressed(nickel(), 0.2, 10).pressure));
}

/// By the step's length and the cell's width, from the state that the particle itself had before.
TEST(MieGruneisen, AStepAdvancesEachParticlesState) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 10, 2);
  const MieGruneisen material{1, 9000, 1.44, 2, 440, 300, 0.4, 4};
  scene.material = material;
  set_wave(scene, 5);
  const double dt = 1e-4;
  Mpm<1> mpm(scene);
  std::vector<ThermalState> expected(scene.particles.size(), material.state_at_rest());
  for (int k = 0; k < 20; ++k) {
    const auto& before = mpm.particles();
    for (std::size_t p = 0; p < expected.size(); ++p)
      material.advance(expected[before.id[p]], before.F[p].determinant(), {dt, scene.h});
    ASSERT_TRUE(mpm.step(dt)) << mpm.fault();
  }
  double viscous = 0;
  for (std::size_t p = 0; p < expected.size(); ++p) {
    const ThermalState &found = mpm.particles().thermal[p], &wanted = expected[mpm.particles().id[p]];
    EXPECT_NEAR(found.J, wanted.J, 1e-15);
    EXPECT_NEAR(found.viscous, wanted.viscous, 1e-12);
    EXPECT_NEAR(found.energy, wanted.energy, 1e-12);
    EXPECT_NEAR(found.temperature, wanted.temperature, 1e-10);
    viscous = std::max(viscous, wanted.viscous);
  }
  EXPECT_GT(viscous, 0.1);
}

TEST(MieGruneisen, PushesEquallyInAllDirections) {
  const MieGruneisen material = nickel(0.4, 4);
  Mat<2> F;
  F << 0.9, 0.1, 0, 0.95;
  ThermalState state = material.state_at_rest(), same = state;
  const Mat<2> tau = material.kirchhoff(F, state, {1e-9, 1e-4});
  material.advance(same, F.determinant(), {1e-9, 1e-4});
  EXPECT_EQ(tau(0, 1), 0);
  EXPECT_EQ(tau(0, 0), tau(1, 1));
  EXPECT_NEAR(tau(0, 0), -F.determinant() * (same.pressure + same.viscous), 1);
}

}  // namespace mpmvv::solver::mie_gruneisen_test
