#include "mms/derived.hpp"

#include <gtest/gtest.h>

#include "mms/bar.hpp"

namespace mpmvv::mms {
namespace {

constexpr Elasticity steel_like{1e4, 0, 1};

Derived<1, BarDisplacement, NeoHookeanLogEnergy> derived_bar(double amplitude) {
  const double C = std::sqrt(steel_like.youngs_modulus / steel_like.density);
  return {BarDisplacement{amplitude, C}, {steel_like.lambda(), steel_like.mu()}, steel_like.density, amplitude};
}

/// X-derive: every closed form equals the one derived from the displacement alone.
TEST(BarSolution, ClosedFormsEqualDerivedOnes) {
  for (const double amplitude : {0.02, 0.05, 0.1}) {
    const Bar bar(amplitude, steel_like);
    const auto derived = derived_bar(amplitude);
    for (int j = 0; j <= 16; ++j)
      for (int k = 0; k <= 8; ++k) {
        const Vec<1> X(j / 16.0);
        const double t = k * 0.0025;
        EXPECT_NEAR(bar.u(X, t)[0], derived.u(X, t)[0], 1e-12 * amplitude);
        EXPECT_NEAR(bar.v(X, t)[0], derived.v(X, t)[0], 1e-12 * amplitude * 314);
        EXPECT_NEAR(bar.a(X, t)[0], derived.a(X, t)[0], 1e-11 * amplitude * 98696);
        EXPECT_NEAR(bar.F(X, t)(0, 0), derived.F(X, t)(0, 0), 1e-13);
        EXPECT_NEAR(bar.P(X, t)(0, 0), derived.P(X, t)(0, 0), 1e-12 * 1e4);
        EXPECT_NEAR(bar.b(X, t)[0], derived.b(X, t)[0], 1e-10 * amplitude * 98696);
      }
  }
}

/// The derivation itself, on a field whose derivatives are known: simple shear that grows as t².
struct ShearField {
  template <class T>
  std::array<T, 2> operator()(const std::array<T, 2>& X, const T& t) const {
    return {X[1] * X[1] * t * t, 0.0 * X[0]};
  }
};

TEST(Derived, PlaneShearByHand) {
  const double mu = 3, rho = 2;
  const Derived<2, ShearField, NeoHookeanLogEnergy> shear({}, {5, mu}, rho, 1);
  const Vec<2> X(0.3, 0.7);
  const double t = 0.5, g = 2 * X[1] * t * t;  // F_xy
  EXPECT_NEAR(shear.v(X, t)[0], 2 * t * X[1] * X[1], 1e-15);
  EXPECT_NEAR(shear.a(X, t)[0], 2 * X[1] * X[1], 1e-15);
  EXPECT_NEAR(shear.F(X, t)(0, 1), g, 1e-15);
  // J = 1, so P = μ (F - F⁻ᵀ): P_xy = μ g, P_yx = μ g, the rest zero.
  EXPECT_NEAR(shear.P(X, t)(0, 1), mu * g, 1e-14);
  EXPECT_NEAR(shear.P(X, t)(1, 0), mu * g, 1e-14);
  EXPECT_NEAR(shear.P(X, t)(0, 0), 0, 1e-14);
  // Div P_x = ∂(μ g)/∂Y = 2 μ t².
  EXPECT_NEAR(shear.b(X, t)[0], 2 * X[1] * X[1] - 2 * mu * t * t / rho, 1e-13);
  EXPECT_NEAR(shear.b(X, t)[1], 0, 1e-13);
}

TEST(BarSolution, ReferencePointInvertsTheMotion) {
  const Bar bar(0.1, steel_like);
  for (int k = 0; k <= 20; ++k) {
    const Vec<1> X(k / 20.0);
    EXPECT_NEAR(bar.reference_point(X + bar.u(X, 0.0003), 0.0003)[0], X[0], 1e-14);
  }
}

TEST(BarSolution, PointwiseEqualsDirect) {
  const Bar bar(0.05, steel_like);
  std::vector<Vec<1>> X;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t k = 0; k < 10; ++k) X.emplace_back(k * 0.1 + 0.03), ids.push_back(9 - k);
  const auto points = bar.at_points(X);
  std::vector<Vec<1>> u(10), b(10);
  points->displacement(0.0012, ids, u.data());
  points->body_force(0.0012, ids, b.data());
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_NEAR(u[k][0], bar.u(X[9 - k], 0.0012)[0], 1e-16);
    EXPECT_NEAR(b[k][0], bar.b(X[9 - k], 0.0012)[0], 1e-11);
  }
}

}  // namespace
}  // namespace mpmvv::mms
