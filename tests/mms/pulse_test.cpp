#include "mms/pulse.hpp"

#include <gtest/gtest.h>

namespace mpmvv::mms::pulse_test {

constexpr double E = 1e7, density = 1000, stress = 500, duration = 1e-3, speed = 100;

/// Places that the rising, the falling and no part of the wave has reached at some times, away from its kinks.
template <class Check>
void everywhere(const Check& check) {
  const Pulse pulse(stress, duration, E, density);
  for (const double t : {0.0, 2e-4, 7.3e-4, 1.5e-3})
    for (const double X : {0.0013, 0.0311, 0.0717, 0.1139, 0.149, 0.19}) check(pulse, Vec<2>(X, 0.004), t);
}

TEST(Pulse, IsAMotion) {  // v and a are the rates of u, F its gradient
  everywhere([](const Pulse& pulse, const Vec<2>& X, double t) {
    const double dt = 1e-8, dx = 1e-6;
    const Vec<2> ahead = pulse.u(X, t + dt), behind = pulse.u(X, t - dt), now = pulse.u(X, t);
    const double v = speed / E * stress;
    EXPECT_LT((pulse.v(X, t) - (ahead - behind) / (2 * dt)).norm(), 1e-6 * v);
    EXPECT_LT((pulse.a(X, t) - (pulse.v(X, t + dt) - pulse.v(X, t - dt)) / (2 * dt)).norm(), 1e-6 * v / duration);
    const Vec<2> slope = (pulse.u(X + dx * Vec<2>::Unit(0), t) - pulse.u(X - dx * Vec<2>::Unit(0), t)) / (2 * dx);
    EXPECT_LT((pulse.F(X, t).col(0) - Vec<2>::Unit(0) - slope).norm(), 1e-6 * stress / E) << now;
    EXPECT_EQ(pulse.F(X, t).col(1), Vec<2>::Unit(1));
  });
}

TEST(Pulse, BalancesMomentumWithoutABodyForce) {  // Div P = ρ₀ a, P = E ε
  everywhere([](const Pulse& pulse, const Vec<2>& X, double t) {
    const double dx = 1e-6;
    const Vec<2> div = (pulse.P(X + dx * Vec<2>::Unit(0), t) - pulse.P(X - dx * Vec<2>::Unit(0), t)).col(0) / (2 * dx);
    EXPECT_LT((div - density * pulse.a(X, t)).norm(), 1e-6 * density * speed / E * stress / duration);
    EXPECT_NEAR(pulse.P(X, t)(0, 0), E * (pulse.F(X, t)(0, 0) - 1), 1e-15 * E);
    EXPECT_EQ(pulse.b(X, t).norm(), 0);
  });
}

TEST(Pulse, IsThePrintedTriangleAtTheEnd) {  // N §3.3: σ_xx = 0.0005 tri((150 - x)/100, 1) MPa, x in mm, at 1.5 ms
  const Pulse pulse(stress, duration, E, density);
  EXPECT_NEAR(pulse.P({0.1, 0}, 1.5e-3)(0, 0), stress, 1e-9);
  EXPECT_NEAR(pulse.P({0.075, 0}, 1.5e-3)(0, 0), stress / 2, 1e-9);
  EXPECT_NEAR(pulse.P({0.14, 0}, 1.5e-3)(0, 0), 0.2 * stress, 1e-9);
  EXPECT_NEAR(pulse.P({0.04, 0}, 1.5e-3)(0, 0), 0, 1e-9);
  EXPECT_NEAR(pulse.P({0.16, 0}, 1.5e-3)(0, 0), 0, 1e-9);
}

TEST(Pulse, PullsTheEndAndStopsIt) {  // its end has moved by c/E times the impulse, the triangle's area, for good
  const Pulse pulse(stress, duration, E, density);
  EXPECT_NEAR(pulse.u({0, 0}, 1.2e-3)[0], -speed / E * stress * duration / 2, 1e-18);
  EXPECT_NEAR(pulse.displacement_scale(), std::abs(pulse.u({0, 0}, 1.2e-3)[0]), 1e-18);
  EXPECT_EQ(pulse.v({0, 0}, 1.2e-3)[0], 0);
}

}  // namespace mpmvv::mms::pulse_test
