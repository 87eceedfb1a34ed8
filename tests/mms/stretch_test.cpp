#include "mms/stretch.hpp"

#include <gtest/gtest.h>

#include "mms/derived.hpp"

namespace mpmvv::mms::stretch_test {

template <int D>
void expect_as_derived(const Elasticity& material) {
  const double rate = 0.3;
  const Stretch<D> closed(rate, material, 1);
  const Derived<D, StretchDisplacement<D>, NeoHookeanSquareEnergy> derived({rate}, {material.lambda(), material.mu()},
                                                                           material.density, 1);
  for (const double t : {0.0, 0.5, 4.0, 20.0})
    for (const double x : {-3.0, 0.0, 0.7}) {
      Vec<D> X = Vec<D>::Constant(0.4);
      X[0] = x;
      EXPECT_LT((closed.u(X, t) - derived.u(X, t)).norm(), 1e-14);
      EXPECT_LT((closed.v(X, t) - derived.v(X, t)).norm(), 1e-14);
      EXPECT_LT((closed.a(X, t) - derived.a(X, t)).norm(), 1e-14);
      EXPECT_LT((closed.F(X, t) - derived.F(X, t)).norm(), 1e-14);
      EXPECT_LT((closed.P(X, t) - derived.P(X, t)).norm(), 1e-12 * material.youngs_modulus);
      EXPECT_LT((closed.b(X, t) - derived.b(X, t)).norm(), 1e-14);
    }
}

TEST(Stretch, ClosedFormsEqualDerivedOnes) {
  for (const Elasticity& material : {Elasticity{0.75, 0, 1}, Elasticity{3, 0.3, 7}}) {
    expect_as_derived<1>(material);
    expect_as_derived<2>(material);
    expect_as_derived<3>(material);
  }
}

/// σ_xx and σ_yy as N §3.4 prints them.
TEST(Stretch, StressesArePrintedOnes) {
  const Elasticity material{3, 0.3, 1};
  const Stretch<3> stretch(0.0025, material, 1);
  for (const double t : {1.0, 80.0, 1200.0}) {
    const double strain = 0.0025 * t, quotient = (2 + strain) * strain / (2 * (1 + strain));
    const Mat<3> F = stretch.F(Vec<3>::Zero(), t), sigma = stretch.P(Vec<3>::Zero(), t) * F.transpose() / (1 + strain);
    EXPECT_NEAR(sigma(0, 0), (material.lambda() + 2 * material.mu()) * quotient, 1e-14);
    EXPECT_NEAR(sigma(1, 1), material.lambda() * quotient, 1e-14);
    EXPECT_NEAR(sigma(2, 2), material.lambda() * quotient, 1e-14);
  }
}

/// P = 2G (J - 1/J)/2, alone along x, where λ is zero: the sides are free.
TEST(Stretch, HasFreeSidesWithoutPoissonsRatio) {
  const Mat<2> P = Stretch<2>(0.0025, {0.75, 0, 1}, 1).P({3, 1}, 80);
  EXPECT_DOUBLE_EQ(P(0, 0), 0.375 * (1.2 - 1 / 1.2));
  EXPECT_EQ(P(0, 1), 0);
  EXPECT_EQ(P(1, 0), 0);
  EXPECT_EQ(P(1, 1), 0);
}

}  // namespace mpmvv::mms::stretch_test
