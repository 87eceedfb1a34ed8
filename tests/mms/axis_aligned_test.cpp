#include <gtest/gtest.h>

#include "tests/mms/samples.hpp"

namespace mpmvv::mms::axis_aligned_test {

/// Normal displacement and shear vanish on the faces of square and cube, which so are symmetry planes and smooth walls.
template <class S>
class AxisAlignedSolution : public ::testing::Test {};
using AxisAlignedSamples = ::testing::Types<SquareSample, CubeSample, SquareAtRestSample, CubeAtRestSample>;
TYPED_TEST_SUITE(AxisAlignedSolution, AxisAlignedSamples);

TYPED_TEST(AxisAlignedSolution, FacesStayInPlaceAndCarryNoShear) {
  constexpr int D = TypeParam::dimension;
  for (const TypeParam& sample : samples<TypeParam>()) {
    const auto closed = sample.closed();
    for (int axis = 0; axis < D; ++axis)
      for (const double face : {0.0, 1.0})
        for (const double t : {0.0, 0.13 * sample.period(), 0.5 * sample.period()}) {
          Vec<D> X = Vec<D>::Constant(0.23);
          X[axis] = face;
          EXPECT_NEAR(closed.u(X, t)[axis], 0, 1e-15 * std::abs(sample.amplitude));
          EXPECT_NEAR(closed.v(X, t)[axis], 0, 1e-15 * std::abs(sample.amplitude) * M_PI * sample.wave_speed());
          const Mat<D> P = closed.P(X, t);
          EXPECT_EQ((P - Mat<D>(P.diagonal().asDiagonal())).norm(), 0);
        }
  }
}

TEST(CubeSolution, IsPeriodic) {
  for (const CubeSample& sample : samples<CubeSample>()) {
    const Cube cube = sample.closed();
    const Vec<3> X(0.11, 0.42, 0.93);
    const double t = 0.21 * sample.period();
    for (int axis = 0; axis < 3; ++axis) {
      const Vec<3> shifted = X + Vec<3>::Unit(axis);
      EXPECT_LT((cube.u(shifted, t) - cube.u(X, t)).norm(), 1e-14);
      EXPECT_LT((cube.P(shifted, t) - cube.P(X, t)).norm(), 1e-12 * cube.P(X, t).norm());
      EXPECT_LT((cube.b(shifted, t) - cube.b(X, t)).norm(), 1e-12 * cube.b(X, t).norm());
    }
  }
}

}  // namespace mpmvv::mms::axis_aligned_test
