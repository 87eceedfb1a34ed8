#include "mms/vortex.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/mms/samples.hpp"

namespace mpmvv::mms::vortex_test {

template <class Check>
void everywhere_in_the_vortex(const Check& check) {
  for (const VortexSample& sample : samples<VortexSample>())
    for (const double phase : {0.0, 0.1, 0.25, 0.6, 0.9})
      for (const Vec<2>& X : sample.points()) check(sample, X, phase * sample.period());
}

/// x = X turned by α, docs/problems.md, "Vortex".
TEST(Vortex, TurnsByThePrintedAngle) {
  everywhere_in_the_vortex([](const VortexSample& sample, const Vec<2>& X, double t) {
    const auto [R_I, R_O] = sample.radii;
    const double s = (X.norm() - (R_I + R_O) / 2) / (R_O - R_I);
    const double alpha =
        sample.amplitude * std::sin(M_PI * t / sample.turning_time) * (1 - 8 * s * s + 16 * std::pow(s, 4));
    const double at = std::atan2(X[1], X[0]) + alpha;
    const Vec<2> x = X.norm() * Vec<2>(std::cos(at), std::sin(at));
    EXPECT_LT((X + sample.closed().u(X, t) - x).norm(), 1e-14);
  });
}

TEST(Vortex, KeepsVolume) {
  everywhere_in_the_vortex([](const VortexSample& sample, const Vec<2>& X, double t) {
    EXPECT_NEAR(sample.closed().F(X, t).determinant(), 1, 1e-14);
  });
}

/// Both circles stay at rest and carry no traction.
TEST(Vortex, CirclesRestAndAreFree) {
  for (const VortexSample& sample : samples<VortexSample>())
    for (const double R : {sample.radii.inner, sample.radii.outer})
      for (const Vec<2>& e_R : directions<2>()) {
        const Vortex vortex = sample.closed();
        const double t = 0.2 * sample.period();
        EXPECT_LT(vortex.u(R * e_R, t).norm(), 1e-14);
        EXPECT_LT((vortex.F(R * e_R, t) - Mat<2>::Identity()).norm(), 1e-13);
        EXPECT_LT(vortex.traction(R * e_R, e_R, t).norm(), 1e-13 * sample.material.youngs_modulus);
      }
}

/// λ drops out where ln J = 0: materials with the same μ and density but any ν have the same stress and body force.
TEST(Vortex, IsTheSameForEveryLambda) {
  everywhere_in_the_vortex([](const VortexSample& sample, const Vec<2>& X, double t) {
    const Elasticity& material = sample.material;
    const auto closed = sample.closed();
    for (const double nu : {-0.5, 0.0, 0.49}) {
      const Elasticity other{material.mu() * 2 * (1 + nu), nu, material.density};
      const auto solution = derived<2>(sample.displacement(), other, closed.displacement_scale());
      EXPECT_LT((solution.P(X, t) - closed.P(X, t)).norm(), 1e-12 * other.youngs_modulus);
      EXPECT_LT((solution.b(X, t) - closed.b(X, t)).norm(), 1e-11 * other.youngs_modulus / other.density);
    }
  });
}

}  // namespace mpmvv::mms::vortex_test
