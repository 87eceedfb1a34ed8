#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>

#include "solver/kernels/block_kernels.hpp"

namespace mpmvv::solver::deformation_test {

constexpr double round_off = 12 * 3e-16;  // of twelve terms

template <class Matrix>
Matrix stepped(const Matrix& F, const Matrix& L, double dt, Deformation rule) {
  return DeformationStep{dt, rule}(F, L);
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
  EXPECT_LT((stepped(F, L, 0.1, Deformation::linear) - expected).norm(), 1e-15 * 10);
}

TYPED_TEST(DeformationRule, ExponentialIsTheMatrixExponential) {
  for (int trial = 0; trial < 20; ++trial) {
    const auto F = this->any(2), L = this->any(1);
    const double dt = 0.4 / L.norm();
    // Eigen's for matrices of any size: one for each size takes two seconds longer to compile.
    const Eigen::MatrixXd exponential = Eigen::MatrixXd(dt * L).exp();
    const typename TestFixture::Matrix expected = exponential * F;
    EXPECT_LT((stepped(F, L, dt, Deformation::exponential) - expected).norm(), round_off * F.norm());
  }
}

TYPED_TEST(DeformationRule, ExponentialStepsAddUp) {  // exp(A) exp(A) = exp(2 A), where (I + A)² is not I + 2 A

  const auto F = this->any(1), L = this->any(1);
  const auto half = stepped(stepped(F, L, 0.1, Deformation::exponential), L, 0.1, Deformation::exponential);
  EXPECT_LT((half - stepped(F, L, 0.2, Deformation::exponential)).norm(), 1e-15);
}

TEST(Exponential, OfASpinIsARotation) {
  const Vec<3> axis = Vec<3>(1, -2, 0.5).normalized();
  Mat<3> spin;
  spin << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
  const Mat<3> rotation = Eigen::AngleAxisd(0.25, axis).toRotationMatrix();
  EXPECT_LT((stepped<Mat<3>>(Mat<3>::Identity(), spin, 0.25, Deformation::exponential) - rotation).norm(), round_off);
}

TEST(Exponential, KeepsTheVolumeWithoutATrace) {
  Mat<2> L;
  L << 0.3, -0.7, 0.9, -0.3;
  EXPECT_NEAR(stepped<Mat<2>>(Mat<2>::Identity(), L, 0.5, Deformation::exponential).determinant(), 1, 1e-15);
}

/// Of a block's six particles, two packs, one with this deformation gradient and velocity gradient.
Fault fault_of(std::size_t p, const Mat<2>& F, const Mat<2>& L) {
  Particles<2> particles;
  particles.F.assign(6, Mat<2>::Identity());
  particles.F[p] = F;
  Block<2> block(0);
  block.begin = 0, block.count = 6;
  std::fill_n(block.L, 6, Mat<2>::Zero());
  block.L[p] = L;
  const Grid<2> grid({0, 0}, 1, {1, 1}, 0, 0);
  const Fault found = UpdateDeformation<2>{particles, DeformationStep{1}}(block, grid);
  EXPECT_EQ((CheckDeformation<2>{particles}(block, grid)), found);
  for (std::size_t other = 0; other < 6; ++other)
    if (other != p) EXPECT_EQ(particles.F[other], (Mat<2>::Identity())) << other;
  return found;
}

TEST(Inverted, ParticlesAreFoundWhereverTheyAreInTheirBlock) {
  const Mat<2> identity = Mat<2>::Identity(), flat = Vec<2>(-1, 0).asDiagonal(), turned_over = 2 * flat;
  for (std::size_t p = 0; p < 6; ++p) {
    EXPECT_EQ(fault_of(p, identity, -0.9 * identity), Fault::none) << p;
    EXPECT_EQ(fault_of(p, identity, flat), Fault::inverted) << p;
    EXPECT_EQ(fault_of(p, identity, turned_over), Fault::inverted) << p;
    EXPECT_EQ(fault_of(p, std::nan("") * identity, identity), Fault::inverted) << p;
  }
}

}  // namespace mpmvv::solver::deformation_test
