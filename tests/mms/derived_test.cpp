#include "mms/derived.hpp"

#include <gtest/gtest.h>

namespace mpmvv::mms {
namespace {

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

}  // namespace
}  // namespace mpmvv::mms
