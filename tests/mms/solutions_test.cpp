#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <thread>

#include "mms/bar.hpp"
#include "mms/cube.hpp"
#include "mms/derived.hpp"
#include "mms/square.hpp"

namespace mpmvv::mms {
namespace {

/// A solution to try the properties with: its closed forms, the displacement alone, and its period in time.
template <class Closed, class Displacement, int D>
struct Sample {
  static constexpr int dimension = D;
  double amplitude;
  Elasticity material;

  double wave_speed() const { return std::sqrt(material.youngs_modulus / material.density); }
  double period() const { return 2 / wave_speed(); }
  Closed closed() const { return {amplitude, material}; }
  Displacement displacement() const { return {amplitude, wave_speed()}; }
  Derived<D, Displacement, NeoHookeanLogEnergy> derived() const {
    return {displacement(), {material.lambda(), material.mu()}, material.density, amplitude};
  }
};

using BarSample = Sample<Bar, BarDisplacement, 1>;
using SquareSample = Sample<Square, SquareDisplacement, 2>;
using CubeSample = Sample<Cube, CubeDisplacement, 3>;

/// A new solution adds its own: defaults, other constants, and an amplitude near the largest that keeps det F > 0.
template <class S>
std::vector<S> samples();
template <>
std::vector<BarSample> samples() {
  return {{0.02, {1e4, 0, 1}}, {0.05, {1e4, 0, 1}}, {-0.15, {3e5, 0, 7}}};
}
template <>
std::vector<SquareSample> samples() {
  return {{0.1, {1e4, 0.3, 1}}, {0.01, {1e4, 0, 1}}, {-0.3, {3e5, 0.45, 7}}};
}
template <>
std::vector<CubeSample> samples() {
  return {{0.05, {1e4, 0.3, 1}}, {0.01, {1e4, 0, 1}}, {-0.15, {3e5, 0.45, 7}}};
}

template <class S>
class Solution : public ::testing::Test {
 protected:
  /// Points of the unit cell, its corners, edges and symmetry points among them, at times over the period.
  template <class Check>
  static void everywhere(const Check& check) {
    constexpr int D = S::dimension;
    constexpr double coordinates[] = {0, 0.1, 0.25, 0.37, 0.5, 0.75, 0.9, 1};
    constexpr int n = std::size(coordinates);
    for (const S& sample : samples<S>())
      for (const double phase : {0.0, 0.125, 0.25, 0.4, 0.5, 0.75, 0.81, 1.0})
        for (int k = 0; k < std::pow(n, D); ++k) {
          Vec<D> X;
          for (int d = 0, rest = k; d < D; ++d, rest /= n) X[d] = coordinates[rest % n];
          check(sample, X, phase * sample.period());
        }
  }
};

using AllSolutions = ::testing::Types<BarSample, SquareSample, CubeSample>;
TYPED_TEST_SUITE(Solution, AllSolutions);

/// X-derive: every closed form equals the one derived from the displacement alone.
TYPED_TEST(Solution, ClosedFormsEqualDerivedOnes) {
  this->everywhere([](const TypeParam& sample, const auto& X, double t) {
    const auto closed = sample.closed();
    const auto derived = sample.derived();
    const double A = std::abs(sample.amplitude), rate = M_PI * sample.wave_speed(), E = sample.material.youngs_modulus;
    EXPECT_LT((closed.u(X, t) - derived.u(X, t)).norm(), 1e-14 * A);
    EXPECT_LT((closed.v(X, t) - derived.v(X, t)).norm(), 1e-13 * A * rate);
    EXPECT_LT((closed.a(X, t) - derived.a(X, t)).norm(), 1e-13 * A * rate * rate);
    EXPECT_LT((closed.F(X, t) - derived.F(X, t)).norm(), 1e-14);
    EXPECT_LT((closed.P(X, t) - derived.P(X, t)).norm(), 1e-12 * E);
    EXPECT_LT((closed.b(X, t) - derived.b(X, t)).norm(), 1e-10 * derived.b(X, t).norm() + 1e-13 * A * rate * rate);
  });
}

/// Central difference of fourth order.
template <class Field>
auto difference(const Field& field, double step) {
  return ((8 * (field(step) - field(-step)) - (field(2 * step) - field(-2 * step))) / (12 * step)).eval();
}

/// Div P + ρ₀ b = ρ₀ a, W (52), with a, F and Div P made by differences of the displacement and P from W (54).
TYPED_TEST(Solution, BalancesMomentum) {
  constexpr int D = TypeParam::dimension;
  this->everywhere([](const TypeParam& sample, const Vec<D>& X, double t) {
    const auto displacement = sample.displacement();
    const auto u = [&](const Vec<D>& at, double time) {
      std::array<double, D> place;
      std::copy_n(at.data(), D, place.begin());
      const auto value = displacement(place, time);
      return Vec<D>(Eigen::Map<const Vec<D>>(value.data()));
    };
    constexpr double step = 1e-3;
    const auto P = [&](const Vec<D>& at) {
      Mat<D> F = Mat<D>::Identity();
      for (int J = 0; J < D; ++J)
        F.col(J) += difference([&](double s) { return u(at + s * Vec<D>::Unit(J), t); }, step);
      const Mat<D> inverse_transpose = F.inverse().transpose();
      return Mat<D>(sample.material.lambda() * std::log(F.determinant()) * inverse_transpose +
                    sample.material.mu() * (F - inverse_transpose));
    };
    Vec<D> div_P = Vec<D>::Zero();
    for (int J = 0; J < D; ++J) div_P += difference([&](double s) { return P(X + s * Vec<D>::Unit(J)); }, step).col(J);
    const double tau = step * sample.period();
    const auto v = [&](double time) { return difference([&](double s) { return u(X, time + s); }, tau); };
    const Vec<D> a = difference([&](double s) { return v(t + s); }, tau);
    const Vec<D> b = sample.closed().b(X, t);
    const double scale = std::abs(sample.amplitude) * std::pow(M_PI * sample.wave_speed(), 2);
    EXPECT_LT((div_P + sample.material.density * (b - a)).norm(), 1e-5 * sample.material.density * (scale + b.norm()))
        << X.transpose();
  });
}

TYPED_TEST(Solution, ReferencePointInvertsTheMotion) {
  this->everywhere([](const TypeParam& sample, const auto& X, double t) {
    const auto closed = sample.closed();
    EXPECT_LT((closed.reference_point(X + closed.u(X, t), t) - X).norm(), 1e-13);
  });
}

/// For any number of points in any order, some of them twice.
TYPED_TEST(Solution, PointwiseEqualsDirect) {
  constexpr int D = TypeParam::dimension;
  for (const TypeParam& sample : samples<TypeParam>()) {
    const auto closed = sample.closed();
    const double t = 0.3 * sample.period(), rate = M_PI * sample.wave_speed();
    std::vector<Vec<D>> X;
    for (int k = 0; k < 100; ++k) {
      X.emplace_back();
      for (int d = 0; d < D; ++d) X.back()[d] = (k * (d + 3) % 40 + 0.5) / 40;
    }
    const auto points = closed.at_points(X);
    for (const std::uint32_t count : {0U, 1U, 31U, 32U, 33U, 71U}) {
      std::vector<std::uint32_t> ids;
      for (std::uint32_t k = 0; k < count; ++k) ids.push_back(99 - k % 64);
      std::vector<Vec<D>> u(count + 1, Vec<D>::Constant(-7)), b(u);
      points->displacement(t, ids, u.data());
      points->body_force(t, ids, b.data());
      for (std::size_t k = 0; k < count; ++k) {
        const Vec<D>& at = X[ids[k]];
        EXPECT_LT((u[k] - closed.u(at, t)).norm(), 1e-15 * std::abs(sample.amplitude));
        EXPECT_LT((b[k] - closed.b(at, t)).norm(),
                  1e-13 * (closed.b(at, t).norm() + std::abs(sample.amplitude) * rate * rate));
      }
      EXPECT_EQ(u[count], Vec<D>::Constant(-7));
      EXPECT_EQ(b[count], Vec<D>::Constant(-7));
    }
  }
}

TYPED_TEST(Solution, PointwiseServesThreadsAtDifferentTimes) {
  constexpr int D = TypeParam::dimension;
  const TypeParam sample = samples<TypeParam>().front();
  const auto closed = sample.closed();
  const std::vector<Vec<D>> X{Vec<D>::Constant(0.2), Vec<D>::Constant(0.7)};
  const auto points = closed.at_points(X);
  const auto work = [&](double phase, double& worst) {
    const std::vector<std::uint32_t> ids{1, 0};
    Vec<D> b[2];
    for (int k = 0; k < 2000; ++k) {
      const double t = (phase + k % 7) * sample.period();
      points->body_force(t, ids, b);
      worst = std::max(worst, (b[0] - closed.b(X[1], t)).norm() / closed.b(X[1], t).norm());
    }
  };
  double worst[2] = {0, 0};
  std::thread other(work, 0.1, std::ref(worst[0]));
  work(0.6, worst[1]);
  other.join();
  EXPECT_LT(worst[0], 1e-12);
  EXPECT_LT(worst[1], 1e-12);
}

/// Normal displacement and shear vanish on the faces of square and cube, which so are symmetry planes and smooth walls.
template <class S>
class AxisAlignedSolution : public ::testing::Test {};
using AxisAlignedSamples = ::testing::Types<SquareSample, CubeSample>;
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

/// The square's motion in three dimensions: W (56) with its third component.
struct SlabDisplacement {
  SquareDisplacement square;
  template <class T>
  std::array<T, 3> operator()(const std::array<T, 3>& X, const T& t) const {
    const auto u = square(std::array<T, 2>{X[0], X[1]}, t);
    return {u[0], u[1], 0.0 * X[2]};
  }
};

/// Plane strain: with F_ZZ = 1 the law in two dimensions is the law in three, and P_ZZ = λK, W (58).
TEST(SquareSolution, IsPlaneStrain) {
  for (const SquareSample& sample : samples<SquareSample>()) {
    const Square square = sample.closed();
    const double lambda = sample.material.lambda(), E = sample.material.youngs_modulus;
    const Derived<3, SlabDisplacement, NeoHookeanLogEnergy> slab(
        {sample.displacement()}, {lambda, sample.material.mu()}, sample.material.density, sample.amplitude);
    for (const double x : {0.0, 0.2, 0.5, 0.8}) {
      const Vec<2> X(x, 0.3);
      const double t = 0.37 * sample.period();
      const Mat<3> P = slab.P(Vec<3>(X[0], X[1], 0.6), t);
      Mat<3> expected = Mat<3>::Zero();
      expected.topLeftCorner<2, 2>() = square.P(X, t);
      expected(2, 2) = lambda * std::log(square.F(X, t).determinant());
      EXPECT_LT((P - expected).norm(), 1e-12 * E);
      const Vec<3> b = slab.b(Vec<3>(X[0], X[1], 0.6), t);
      EXPECT_LT((b.head<2>() - square.b(X, t)).norm(), 1e-10 * b.norm());
      EXPECT_NEAR(b[2], 0, 1e-12 * b.norm());
    }
  }
}

}  // namespace
}  // namespace mpmvv::mms
