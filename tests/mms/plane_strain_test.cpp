#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/mms/samples.hpp"

namespace mpmvv::mms::plane_strain_test {

/// A plane motion in three dimensions.
template <class Displacement>
struct Slab {
  Displacement plane;
  template <class T>
  std::array<T, 3> operator()(const std::array<T, 3>& X, const T& t) const {
    const auto u = plane(std::array<T, 2>{X[0], X[1]}, t);
    return {u[0], u[1], 0.0 * X[2]};
  }
};

template <class S>
class PlaneSolution : public ::testing::Test {};
using PlaneSamples = ::testing::Types<SquareSample, RingSample, VortexSample>;
TYPED_TEST_SUITE(PlaneSolution, PlaneSamples);

/// With F_ZZ = 1 the law in two dimensions is the law in three, and P_ZZ = λK, W (58).
TYPED_TEST(PlaneSolution, IsPlaneStrain) {
  for (const TypeParam& sample : samples<TypeParam>()) {
    const auto closed = sample.closed();
    const auto slab = derived<3>(Slab{sample.displacement()}, sample.material, closed.displacement_scale());
    const double t = 0.37 * sample.period(), E = sample.material.youngs_modulus;
    const double size = closed.displacement_scale() * std::pow(2 * M_PI / sample.period(), 2);  // of the acceleration
    for (const Vec<2>& X : sample.points()) {
      const Vec<3> in_slab(X[0], X[1], 0.6);
      Mat<3> P = Mat<3>::Zero();
      P.template topLeftCorner<2, 2>() = closed.P(X, t);
      P(2, 2) = sample.material.lambda() * std::log(closed.F(X, t).determinant());
      EXPECT_LT((slab.P(in_slab, t) - P).norm(), 1e-12 * E);
      const Vec<3> b = slab.b(in_slab, t);
      EXPECT_LT((b.head<2>() - closed.b(X, t)).norm(), 1e-10 * b.norm() + 1e-13 * size);
      EXPECT_NEAR(b[2], 0, 1e-12 * b.norm());
    }
  }
}

}  // namespace mpmvv::mms::plane_strain_test
