#include <Eigen/Geometry>
#include <random>

#include "mms/derived.hpp"
#include "solver/material/materials.hpp"
#include "solver/simd/pack.hpp"
#include "solver/words.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::material_test {

/// Some deformation gradients with positive determinant, far from the identity.
template <int D>
Array<Mat<D>> deformations() {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> entry(-0.35, 0.35);
  Array<Mat<D>> all;
  while (all.size() < 20) {
    Mat<D> F = Mat<D>::Identity();
    for (int k = 0; k < D * D; ++k) F.data()[k] += entry(random);
    if (F.determinant() > 0.2) all.push_back(F);
  }
  return all;
}

template <class M, int D>
Mat<D> tau_of(const M& material, const Mat<D>& F) {
  return material.kirchhoff(F);
}

/// Materials to try the properties with: of Lamé constants. One of other constants has its own.
template <class M>
std::vector<M> samples() {
  return {{0, 5000}, {3000, 4000}, {1, 0}};
}

/// Small-strain laws take a rotation for a strain.
template <class M>
constexpr bool turns_with_the_body = !std::is_same_v<M, LinearElastic>;

/// Every property is asked of every material of the solver, in every dimension.
template <class M>
class Material : public ::testing::Test {
 protected:
  template <class Check>
  static void everywhere(const Check& check) {
    for (const M& material : samples<M>()) {
      for (const auto& F : deformations<1>()) check(material, F);
      for (const auto& F : deformations<2>()) check(material, F);
      for (const auto& F : deformations<3>()) check(material, F);
    }
  }
};

/// Those whose stress is a function of F; one with a history has tests of its own.
template <class Any, class... Chosen>
struct Potentials {
  using type = ::testing::Types<Chosen...>;
};
template <class First, class... Rest, class... Chosen>
struct Potentials<std::variant<First, Rest...>, Chosen...>
    : std::conditional_t<has_history<First>, Potentials<std::variant<Rest...>, Chosen...>,
                         Potentials<std::variant<Rest...>, Chosen..., First>> {};
TYPED_TEST_SUITE(Material, Potentials<AnyMaterial>::type);

TYPED_TEST(Material, StressIsTheDerivativeOfTheEnergy) {  // τ = ∂W/∂F Fᵀ
  this->everywhere([]<int D>(const TypeParam& material, const Mat<D>& F) {
    const double step = 1e-6;
    Mat<D> P;
    for (int k = 0; k < D * D; ++k) {
      Mat<D> more = F, less = F;
      more.data()[k] += step;
      less.data()[k] -= step;
      P.data()[k] = (material.template energy<D>(more) - material.template energy<D>(less)) / (2 * step);
    }
    const Mat<D> tau = tau_of(material, F);
    EXPECT_LT((tau - P * F.transpose()).norm(), 1e-8 * (1 + tau.norm())) << F;
    if (turns_with_the_body<TypeParam>) {
      EXPECT_LT((tau - tau.transpose()).norm(), 1e-15 * (1 + tau.norm()));
    }
  });
}

/// τ(QF) = Q τ(F) Qᵀ, W(QF) = W(F). The products round to 6e-15 of τ at most in 2,000 such F, with St. Venant and
/// Kirchhoff's law; with the neo-Hookean one to 3e-15.
TYPED_TEST(Material, TurnsWithTheBody) {
  if (!turns_with_the_body<TypeParam>) GTEST_SKIP() << "a small-strain law";
  for (const TypeParam& material : samples<TypeParam>()) {
    const Mat<2> turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
    for (const auto& F : deformations<2>()) {
      const Mat<2> turned = turn * tau_of(material, F) * turn.transpose();
      EXPECT_LT((tau_of<TypeParam, 2>(material, turn * F) - turned).norm(), 1e-14 * (1 + turned.norm()));
      EXPECT_NEAR(material.template energy<2>(turn * F), material.template energy<2>(F), 1e-11);
    }
    const Mat<3> spin = Eigen::AngleAxisd(1.1, Vec<3>(1, -2, 0.5).normalized()).toRotationMatrix();
    for (const auto& F : deformations<3>()) {
      const Mat<3> spun = spin * tau_of(material, F) * spin.transpose();
      EXPECT_LT((tau_of<TypeParam, 3>(material, spin * F) - spun).norm(), 1e-14 * (1 + spun.norm()));
      EXPECT_NEAR(material.template energy<3>(spin * F), material.template energy<3>(F), 1e-11);
    }
  }
}

/// As each by itself does.
template <class M, int D>
void expect_four_at_once(const M& material) {
  const auto all = deformations<D>();
  for (std::size_t k = 0; k + 4 <= all.size(); k += 4) {
    PackMat<D> four;
    load_packs<D * D>({all[k].data(), all[k + 1].data(), all[k + 2].data(), all[k + 3].data()}, four.data());
    const PackMat<D> tau = material.kirchhoff(four);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Mat<D> expected = material.kirchhoff(all[k + lane]);
      for (int i = 0; i < D * D; ++i) EXPECT_NEAR(tau(i)[lane], expected(i), 1e-14 * (1 + expected.norm()));
    }
  }
}

TYPED_TEST(Material, TakesFourAtOnce) {
  for (const TypeParam& material : samples<TypeParam>()) {
    expect_four_at_once<TypeParam, 1>(material);
    expect_four_at_once<TypeParam, 2>(material);
    expect_four_at_once<TypeParam, 3>(material);
  }
}

TYPED_TEST(Material, RestsUndeformed) {
  for (const TypeParam& material : samples<TypeParam>()) {
    EXPECT_EQ((tau_of<TypeParam, 3>(material, Mat<3>::Identity()).norm()), 0);
    EXPECT_EQ(material.template energy<3>(Mat<3>::Identity()), 0);
  }
}

TEST(NeoHookean, InOneDimensionIsThePrintedOne) {  // S (50): P = E/2 (F - 1/F), ν = 0, so μ = E/2
  const double E = 1e4;
  for (const double stretch : {0.4, 0.9, 1.0, 1.3, 2.5})
    EXPECT_NEAR((tau_of<NeoHookeanLog, 1>({0, E / 2}, Mat<1>(stretch))(0, 0)),
                E / 2 * (stretch - 1 / stretch) * stretch, 1e-11);
}

TEST(LinearElastic, IsHookesLawForSmallStrains) {  // in uniaxial strain σ = (λ + 2G) ε; in shear σ = 2 G ε
  const double small = 1e-7;
  Mat<3> F = Mat<3>::Identity();
  F(0, 0) += small;
  const Mat<3> pulled = tau_of(LinearElastic{3000, 4000}, F);
  EXPECT_NEAR(pulled(0, 0), 11000 * small, 1e-9);
  EXPECT_NEAR(pulled(1, 1), 3000 * small, 1e-9);
  F(0, 0) = 1, F(0, 1) = small;
  EXPECT_NEAR(tau_of(LinearElastic{3000, 4000}, F)(0, 1), 4000 * small, 1e-9);
}

/// u = G X, whose deformation gradient is I + G everywhere.
template <int D>
struct UniformDisplacement {
  Mat<D> G;
  template <class T>
  std::array<T, D> operator()(const std::array<T, D>& X, const T&) const {
    std::array<T, D> u;
    for (std::size_t i = 0; i < D; ++i) {
      u[i] = T(0);
      for (std::size_t J = 0; J < D; ++J) u[i] += G(static_cast<int>(i), static_cast<int>(J)) * X[J];
    }
    return u;
  }
};

template <class M, class Energy, int D>
void expect_the_stress_of_the_solutions() {  // made there from another energy, by automatic differentiation
  const double lambda = 3000, mu = 4000;
  for (const auto& F : deformations<D>()) {
    const UniformDisplacement<D> displacement{F - Mat<D>::Identity()};
    const mms::Derived<D, UniformDisplacement<D>, Energy> solution(displacement, {lambda, mu}, 1, 1);
    const Mat<D> tau = solution.P(Vec<D>::Constant(0.3), 0) * F.transpose();
    EXPECT_LT((tau_of(M{lambda, mu}, F) - tau).norm(), 1e-12 * tau.norm());
  }
}

TEST(NeoHookean, IsTheLawOfTheSolutions) {
  expect_the_stress_of_the_solutions<NeoHookeanLog, mms::NeoHookeanLogEnergy, 1>();
  expect_the_stress_of_the_solutions<NeoHookeanLog, mms::NeoHookeanLogEnergy, 2>();
  expect_the_stress_of_the_solutions<NeoHookeanLog, mms::NeoHookeanLogEnergy, 3>();
  expect_the_stress_of_the_solutions<NeoHookeanSquare, mms::NeoHookeanSquareEnergy, 2>();
}

}  // namespace mpmvv::solver::material_test
