#include "mms/derived.hpp"

#include <gtest/gtest.h>

#include "tests/mms/balance.hpp"
#include "tests/mms/differences.hpp"

namespace mpmvv::mms::derived_test {

/// The derivation itself, on a field whose derivatives are known: simple shear that grows as t².
TEST(Derived, PlaneShearByHand) {
  const auto displacement = [](const auto& X, const auto& t) { return std::array{X[1] * X[1] * t * t, 0.0 * t}; };
  const Elasticity material{7, 0.4, 2};
  const double mu = material.mu(), rho = material.density;
  const auto shear = derived<2>(displacement, material, 1);
  const Vec<2> X(0.3, 0.7);
  const double t = 0.5, g = 2 * X[1] * t * t;  // F_xy
  EXPECT_NEAR(shear.u(X, t)[0], X[1] * X[1] * t * t, 1e-15);
  EXPECT_NEAR(shear.v(X, t)[0], 2 * t * X[1] * X[1], 1e-15);
  EXPECT_NEAR(shear.a(X, t)[0], 2 * X[1] * X[1], 1e-15);
  EXPECT_NEAR(shear.F(X, t)(0, 1), g, 1e-15);
  // J = 1, so P = μ (F - F⁻ᵀ): P_xy = μ g, P_yx = μ g, the rest zero.
  EXPECT_NEAR(shear.P(X, t)(0, 1), mu * g, 1e-14);
  EXPECT_NEAR(shear.P(X, t)(1, 0), mu * g, 1e-14);
  EXPECT_NEAR(shear.P(X, t)(0, 0), 0, 1e-14);
  EXPECT_LT((shear.traction(X, {0, -1}, t) - Vec<2>(-mu * g, 0)).norm(), 1e-14);
  // Div P_x = ∂(μ g)/∂Y = 2 μ t².
  EXPECT_NEAR(shear.b(X, t)[0], 2 * X[1] * X[1] - 2 * mu * t * t / rho, 1e-13);
  EXPECT_NEAR(shear.b(X, t)[1], 0, 1e-13);
}

/// A solution of one's own, neither aligned nor symmetric, that moves and loads all four sides of the unit square.
struct ShearAndBend {
  double amplitude, rate;

  template <class T>
  std::array<T, 2> operator()(const std::array<T, 2>& X, const T& t) const {
    using std::cos, std::exp, std::sin;
    return {amplitude * sin(rate * t) * (X[1] + X[0] * X[1] * X[1]),
            amplitude * cos(rate * t - X[1]) * exp(-X[0]) + amplitude * t * X[0]};
  }
};

class UserDefined : public ::testing::Test {
 protected:
  const Elasticity material{10, 0.3, 2};
  const ShearAndBend displacement{0.2, 3};
  const Derived<2, ShearAndBend, NeoHookeanLogEnergy> solution = derived<2>(displacement, material, 0.4);
};

/// Differences in long double of fourth order leave about 1e-12.
TEST_F(UserDefined, FieldsEqualDifferences) {
  using Real = long double;
  const Differences<2, Real, ShearAndBend> expected{displacement, material, 1e-3L, 1e-3L};
  for (const double t : {0.0, 0.3, 1.1})
    for (const Vec<2>& X : {Vec<2>(0, 0), Vec<2>(1, 0.3), Vec<2>(0.4, 1), Vec<2>(0.25, 0.8)}) {
      const Eigen::Matrix<Real, 2, 1> at = X.cast<Real>();
      EXPECT_LT((solution.u(X, t) - expected.u(at, t).cast<double>()).norm(), 1e-15);
      EXPECT_LT((solution.v(X, t) - expected.v(at, t).cast<double>()).norm(), 1e-11);
      EXPECT_LT((solution.a(X, t) - expected.a(at, t).cast<double>()).norm(), 1e-10);
      EXPECT_LT((solution.F(X, t) - expected.F(at, t).cast<double>()).norm(), 1e-12);
      EXPECT_LT((solution.P(X, t) - expected.P(at, t).cast<double>()).norm(), 1e-11);
      EXPECT_LT((solution.b(X, t) - expected.b(at, t).cast<double>()).norm(), 1e-10);
    }
}

TEST_F(UserDefined, TractionOnAllFourSides) {
  using Real = long double;
  const Differences<2, Real, ShearAndBend> expected{displacement, material, 1e-3L, 1e-3L};
  for (int axis = 0; axis < 2; ++axis)
    for (const int side : {0, 1}) {
      Vec<2> X = Vec<2>::Constant(0.35);
      X[axis] = side;
      const Vec<2> N = (2 * side - 1) * Vec<2>::Unit(axis);
      const Vec<2> load = (expected.P(X.cast<Real>(), 0.4L) * N.cast<Real>()).cast<double>();
      EXPECT_GT(load.cwiseAbs().minCoeff(), 0.05) << "every side has to carry pressure and shear";
      EXPECT_LT((solution.traction(X, N, 0.4) - load).norm(), 1e-11);
    }
}

/// ∫ρ₀ b dV + ∮ P N dA = ∫ρ₀ a dV
TEST_F(UserDefined, BalancesForces) {
  for (const double t : {0.0, 0.3, 1.1}) {
    EXPECT_LT(imbalance<2>(solution, material.density, box<2>({0, 0}, {1, 1}), t), 1e-13);
    EXPECT_LT(imbalance<2>(solution, material.density, box<2>({0.1, 0.5}, {0.3, 0.4}), t), 1e-13);
  }
}

}  // namespace mpmvv::mms::derived_test
