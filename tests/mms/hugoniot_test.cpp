#include "mms/hugoniot.hpp"

#include <gtest/gtest.h>

namespace mpmvv::mms::hugoniot_test {

const ShockedSolid nickel{188e9, 8870, 1.44, 2, 444, 300};

TEST(Hugoniot, KeepsMassMomentumAndEnergyAcrossTheShock) {
  for (const double u : {10.0, 500.0, 1840.0, 3000.0}) {
    const Hugoniot shock(nickel, u);
    const double U = shock.shock_speed(), flux = nickel.density * U;
    EXPECT_NEAR(shock.density() * (U - u) / flux, 1, 1e-14);
    EXPECT_NEAR(shock.pressure() / (flux * u), 1, 1e-14);
    EXPECT_NEAR(flux * (shock.energy() + 0.5 * u * u) / (shock.pressure() * u), 1, 1e-14);
  }
}

TEST(Hugoniot, IsLinearInTheSpeedsAndOnItsPressureCurve) {
  const Hugoniot shock(nickel, 1840);
  EXPECT_NEAR(shock.shock_speed(), std::sqrt(188e9 / 8870) + 1.44 * 1840, 1e-9);
  const double eta = shock.compression();
  EXPECT_NEAR(shock.pressure() / (188e9 * eta / std::pow(1 - 1.44 * eta, 2)), 1, 1e-14);
}

TEST(Hugoniot, TemperatureObeysItsDifferentialEquation) {  // C (dT/dη - γ₀ T) = (η dp/dη - p)/(2 ρ₀)
  const double u = 1200, step = 1e-3;
  const Hugoniot less(nickel, u - step), shock(nickel, u), more(nickel, u + step);
  const double width = more.compression() - less.compression();
  const double slope_T = (more.temperature() - less.temperature()) / width;
  const double slope_p = (more.pressure() - less.pressure()) / width;
  EXPECT_NEAR(444 * (slope_T - 2 * shock.temperature()),
              (shock.compression() * slope_p - shock.pressure()) / (2 * 8870), 0.1);
  EXPECT_NEAR(Hugoniot(nickel, 1e-6).temperature(), 300, 1e-4);
}

TEST(Hugoniot, OfAWeakShockIsIsentropic) {  // the entropy rises with the third power of the strength
  const Hugoniot weak(nickel, 1), twice(nickel, 2);
  const auto beyond = [](const Hugoniot& s) { return s.temperature() - 300 * std::exp(2 * s.compression()); };
  EXPECT_NEAR(beyond(twice) / beyond(weak), 8, 0.05);
}

}  // namespace mpmvv::mms::hugoniot_test
