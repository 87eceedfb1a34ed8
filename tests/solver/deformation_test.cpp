#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <unsupported/Eigen/MatrixFunctions>

#include "solver/kernels/block_kernels.hpp"
#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::deformation_test {

constexpr double round_off = 12 * 3e-16;  // of twelve terms

template <class Matrix>
Matrix stepped(const Matrix& F, const Matrix& L, double dt, Deformation rule) {
  const DeformationStep step{dt, rule};
  return rule == Deformation::linear ? step.by<Deformation::linear>(F, L) : step.by<Deformation::exponential>(F, L);
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

/// From F = I by the same velocity gradient: 1 + Δt L, or exp(Δt L).
TEST(Deformation, FollowsTheRuleOfTheScene) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2);
  set_wave(scene, 5);
  for (const std::string_view integrator : {"usl", "usf", "uvf", "usl+"}) {
    scene.integrator = integrator;
    const auto after_a_step = [&scene](Deformation rule) {
      scene.deformation = rule;
      Mpm<1> mpm(scene);
      EXPECT_TRUE(mpm.step(1e-3)) << mpm.fault();
      return mpm.particles().F;
    };
    const auto linear = after_a_step(Deformation::linear), exponential = after_a_step(Deformation::exponential);
    double largest = 0;
    for (std::size_t p = 0; p < linear.size(); ++p) {
      EXPECT_NEAR(exponential[p](0, 0), std::exp(linear[p](0, 0) - 1), 1e-15) << integrator;
      largest = std::max(largest, std::abs(linear[p](0, 0) - 1));
    }
    EXPECT_GT(largest, 0.01);
  }
}

/// Of a block's six particles, two packs, that stand behind three others, one with this F and this velocity gradient.
Fault fault_of(int k, const Mat<2>& F, const Mat<2>& L, Deformation rule) {
  Particles<2> particles;
  particles.F.assign(9, Mat<2>::Identity());
  Block<2> block(0);
  block.begin = 3, block.count = 6;
  std::fill_n(block.L, 6, Mat<2>::Zero());
  const auto p = block.begin + static_cast<std::size_t>(k);
  particles.F[p] = F, block.L[k] = L;
  const Grid<2> grid({0, 0}, 1, {1, 1}, 0, 0);
  const Fault found = UpdateDeformation<2>{particles, DeformationStep{1, rule}}(block, grid);
  EXPECT_EQ((CheckDeformation<2>{particles}(block, grid)), found);
  if (F.allFinite() && L.allFinite()) {
    EXPECT_LT((particles.F[p] - stepped<Mat<2>>(F, L, 1, rule)).norm(), 1e-15);
  }
  particles.F[p].setIdentity();
  EXPECT_EQ(particles.F, Array<Mat<2>>(9, Mat<2>::Identity())) << "others have moved";
  return found;
}

TEST(Inverted, ParticlesAreFoundWhereverTheyAreInTheirBlock) {
  const Mat<2> identity = Mat<2>::Identity(), rest = Mat<2>::Zero(), mirrored = Vec<2>(-1, 1).asDiagonal();
  const Mat<2> to_flat = Vec<2>(-1, 0).asDiagonal(), beyond = 2 * to_flat, no_number = std::nan("") * identity;
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(fault_of(k, identity, -0.9 * identity, Deformation::linear), Fault::none) << k;
    EXPECT_EQ(fault_of(k, identity, to_flat, Deformation::linear), Fault::inverted) << k;
    EXPECT_EQ(fault_of(k, identity, beyond, Deformation::linear), Fault::inverted) << k;
    EXPECT_EQ(fault_of(k, no_number, rest, Deformation::linear), Fault::inverted) << k;
    EXPECT_EQ(fault_of(k, identity, 0.3 * to_flat, Deformation::exponential), Fault::none) << k;
    EXPECT_EQ(fault_of(k, mirrored, rest, Deformation::exponential), Fault::inverted) << k;
    EXPECT_EQ(fault_of(k, identity, no_number, Deformation::exponential), Fault::inverted) << k;
  }
}

}  // namespace mpmvv::solver::deformation_test
