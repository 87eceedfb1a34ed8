#include "solver/deformation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>

namespace mpmvv::solver::deformation_test {

constexpr double round_off = 12 * 3e-16;  // of twelve terms

template <int D>
PaddedMat<D> padded(const Mat<D>& A) {
  PaddedMat<D> result = PaddedMat<D>::Zero();
  result.template topRows<D>() = A;
  return result;
}

template <int D>
Mat<D> stepped(const Mat<D>& F, const Mat<D>& L, double dt, Deformation rule) {
  return DeformationStep<D>{dt, rule}(F, padded<D>(L)).template topRows<D>();
}

template <class Dimension>
class DeformationRule : public ::testing::Test {
 protected:
  static constexpr int D = Dimension::value;
  using Matrix = Mat<D>;

  Matrix any(double largest) {
    std::uniform_real_distribution<double> entry(-largest, largest);
    return Matrix::NullaryExpr([&] { return entry(random_); });
  }

 private:
  std::mt19937 random_{5};
};

using Dimensions =
    ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(DeformationRule, Dimensions);

TYPED_TEST(DeformationRule, LinearIsOnePlusTheIncrement) {
  const auto F = this->any(2), L = this->any(3);
  const auto expected = (F + 0.1 * L * F).eval();
  EXPECT_LT((stepped<TestFixture::D>(F, L, 0.1, Deformation::linear) - expected).norm(), 1e-15 * 10);
}

TYPED_TEST(DeformationRule, ExponentialIsTheMatrixExponential) {
  for (int trial = 0; trial < 20; ++trial) {
    const auto F = this->any(2), L = this->any(1);
    const double dt = 0.4 / L.norm();
    // Eigen's for matrices of any size: one for each size takes two seconds longer to compile.
    const Eigen::MatrixXd exponential = Eigen::MatrixXd(dt * L).exp();
    const typename TestFixture::Matrix expected = exponential * F;
    EXPECT_LT((stepped<TestFixture::D>(F, L, dt, Deformation::exponential) - expected).norm(), round_off * F.norm());
  }
}

TYPED_TEST(DeformationRule, ExponentialStepsAddUp) {  // exp(A) exp(A) = exp(2 A), where (I + A)² is not I + 2 A

  const auto F = this->any(1), L = this->any(1);
  const auto half = stepped<TestFixture::D>(stepped<TestFixture::D>(F, L, 0.1, Deformation::exponential), L, 0.1,
                                            Deformation::exponential);
  EXPECT_LT((half - stepped<TestFixture::D>(F, L, 0.2, Deformation::exponential)).norm(), 1e-15);
}

TEST(Exponential, OfASpinIsARotation) {
  const Vec<3> axis = Vec<3>(1, -2, 0.5).normalized();
  Mat<3> spin;
  spin << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
  const Mat<3> rotation = Eigen::AngleAxisd(0.25, axis).toRotationMatrix();
  EXPECT_LT((stepped<3>(Mat<3>::Identity(), spin, 0.25, Deformation::exponential) - rotation).norm(), round_off);
}

TEST(Exponential, KeepsTheVolumeWithoutATrace) {
  Mat<2> L;
  L << 0.3, -0.7, 0.9, -0.3;
  EXPECT_NEAR(stepped<2>(Mat<2>::Identity(), L, 0.5, Deformation::exponential).determinant(), 1, 1e-15);
}

}  // namespace mpmvv::solver::deformation_test
