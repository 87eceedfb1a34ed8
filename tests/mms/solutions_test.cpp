#include <gtest/gtest.h>

#include <numeric>
#include <thread>

#include "tests/mms/differences.hpp"
#include "tests/mms/samples.hpp"

namespace mpmvv::mms {
namespace solutions_test {

template <class S>
class Solution : public ::testing::Test {
 protected:
  /// At times over the period.
  template <class Check>
  static void everywhere(const Check& check) {
    for (const S& sample : samples<S>())
      for (const double phase : {0.0, 0.125, 0.25, 0.4, 0.5, 0.75, 0.81, 1.0})
        for (const auto& X : sample.points()) check(sample, X, phase * sample.period());
  }
};

/// The places of the points with these ids.
template <int D>
std::vector<Vec<D>> places_of(const std::vector<std::uint32_t>& ids, const std::vector<Vec<D>>& X) {
  std::vector<Vec<D>> places;
  for (const auto id : ids) places.push_back(X[id]);
  return places;
}

/// Of a sample's motion: how far it goes, and how fast its phase grows.
template <class S>
double reach(const S& sample) {
  return sample.closed().displacement_scale();
}
template <class S>
double rate(const S& sample) {
  return 2 * M_PI / sample.period();
}

using AllSolutions = ::testing::Types<BarSample, SquareSample, CubeSample, BarAtRestSample, SquareAtRestSample,
                                      CubeAtRestSample, SquareInverseSample, RingSample, ShellSample, VortexSample>;
TYPED_TEST_SUITE(Solution, AllSolutions);

/// X-derive: every closed form equals the one derived from the displacement alone.
TYPED_TEST(Solution, ClosedFormsEqualDerivedOnes) {
  constexpr int D = TypeParam::dimension;
  this->everywhere([](const TypeParam& sample, const Vec<D>& X, double t) {
    const auto closed = sample.closed();
    const auto by_derivation = derived<D>(sample.displacement(), sample.material, closed.displacement_scale());
    const double A = reach(sample), w = rate(sample), E = sample.material.youngs_modulus;
    const Vec<D> b = by_derivation.b(X, t);
    EXPECT_LT((closed.u(X, t) - by_derivation.u(X, t)).norm(), 1e-14 * A + 4e-16 * X.norm());
    EXPECT_LT((closed.v(X, t) - by_derivation.v(X, t)).norm(), 1e-13 * A * w);
    EXPECT_LT((closed.a(X, t) - by_derivation.a(X, t)).norm(), 1e-13 * A * w * w);
    EXPECT_LT((closed.F(X, t) - by_derivation.F(X, t)).norm(), 1e-14);
    EXPECT_LT((closed.P(X, t) - by_derivation.P(X, t)).norm(), 1e-12 * E);
    EXPECT_LT((closed.b(X, t) - b).norm(), 1e-12 * b.norm() + 1e-13 * A * w * w);
  });
}

/// Div P + ρ₀ b = ρ₀ a, W (52), with everything but b by differences of the displacement.
TYPED_TEST(Solution, BalancesMomentum) {
  constexpr int D = TypeParam::dimension;
  this->everywhere([](const TypeParam& sample, const Vec<D>& X, double t) {
    const auto displacement = sample.displacement();
    const Differences<D, double, decltype(displacement)> expected{displacement, sample.material, 1e-3,
                                                                  1e-3 * sample.period()};
    const Vec<D> b = sample.closed().b(X, t);
    EXPECT_LT((b - expected.b(X, t)).norm(), 1e-5 * (reach(sample) * rate(sample) * rate(sample) + b.norm()))
        << X.transpose();
  });
}

/// ∫ρ₀ b dV + ∮ P N dA = ∫ρ₀ a dV
TYPED_TEST(Solution, BalancesForcesOnAPiece) {
  for (const TypeParam& sample : samples<TypeParam>())
    for (const double phase : {0.15, 0.3, 0.67})
      EXPECT_LT(imbalance(sample.closed(), sample.material.density, sample.piece(), phase * sample.period()), 1e-12);
}

/// P Fᵀ = J σ is symmetric.
TYPED_TEST(Solution, BalancesAngularMomentum) {
  constexpr int D = TypeParam::dimension;
  this->everywhere([](const TypeParam& sample, const Vec<D>& X, double t) {
    const Mat<D> tau = sample.closed().P(X, t) * sample.closed().F(X, t).transpose();
    EXPECT_LT((tau - tau.transpose()).norm(), 1e-14 * sample.material.youngs_modulus);
  });
}

TYPED_TEST(Solution, ReferencePointInvertsTheMotion) {
  this->everywhere([](const TypeParam& sample, const auto& X, double t) {
    const auto closed = sample.closed();
    EXPECT_LT((closed.reference_point(X + closed.u(X, t), t) - X).norm(), 1e-13);
  });
}

/// The largest displacement over body and time, up to a factor of order one.
TYPED_TEST(Solution, KnowsHowFarItGoes) {
  for (const TypeParam& sample : samples<TypeParam>()) {
    const auto closed = sample.closed();
    double largest = 0;
    for (const double phase : {0.0, 0.25, 0.5})
      for (const auto& X : sample.points()) largest = std::max(largest, closed.u(X, phase * sample.period()).norm());
    EXPECT_GT(largest, reach(sample) / 2);
    EXPECT_LT(largest, reach(sample) * 2);
  }
}

/// For any number of points in any order, some of them twice.
TYPED_TEST(Solution, PointwiseEqualsDirect) {
  constexpr int D = TypeParam::dimension;
  for (const TypeParam& sample : samples<TypeParam>()) {
    const auto closed = sample.closed();
    const double t = 0.3 * sample.period();
    std::vector<Vec<D>> X;
    for (std::size_t k = 0; k < 100; ++k) X.push_back(sample.points()[k * 7 % sample.points().size()]);
    const auto points = closed.at_points(X);
    for (const std::uint32_t count : {0U, 1U, 31U, 32U, 33U, 71U}) {
      std::vector<std::uint32_t> ids;
      for (std::uint32_t k = 0; k < count; ++k) ids.push_back(99 - k % 64);
      std::vector<Vec<D>> u(count + 1, Vec<D>::Constant(-7)), b(u);
      points->displacement(t, ids, u.data());
      points->body_force(t, ids, places_of(ids, X), b.data());
      for (std::size_t k = 0; k < count; ++k) {
        const Vec<D>& at = X[ids[k]];
        EXPECT_LT((u[k] - closed.u(at, t)).norm(), 1e-15 * reach(sample));
        EXPECT_LT((b[k] - closed.b(at, t)).norm(),
                  1e-13 * (closed.b(at, t).norm() + reach(sample) * rate(sample) * rate(sample)));
      }
      EXPECT_EQ(u[count], Vec<D>::Constant(-7));
      EXPECT_EQ(b[count], Vec<D>::Constant(-7));
    }
  }
}

/// Bit for bit, whichever points are asked for with it: results do not depend on how particles are cut into blocks.
TYPED_TEST(Solution, PointwiseBodyForceDependsOnThePointAlone) {
  constexpr int D = TypeParam::dimension;
  for (const TypeParam& sample : samples<TypeParam>()) {
    const auto closed = sample.closed();
    const double t = 0.3 * sample.period();
    const auto X = sample.points();
    const auto points = closed.at_points(X);
    std::vector<std::uint32_t> ids(X.size());
    std::iota(ids.begin(), ids.end(), 0U);
    std::vector<Vec<D>> b(X.size());
    points->body_force(t, ids, X, b.data());
    for (const std::uint32_t id : ids) {
      Vec<D> alone;
      points->body_force(t, {&id, 1}, {&X[id], 1}, &alone);
      EXPECT_EQ(alone, b[id]) << X[id].transpose();
    }
  }
}

/// A solution that says that it reads no places gives the same without any.
TYPED_TEST(Solution, PointwiseReadsPlacesOnlyWhereItSaysSo) {
  constexpr int D = TypeParam::dimension;
  const auto closed = samples<TypeParam>().front().closed();
  const auto X = samples<TypeParam>().front().points();
  const auto points = closed.at_points(X);
  if (points->reads_places()) GTEST_SKIP() << "reads them";
  const std::vector<std::uint32_t> ids{2, 0, 1};
  std::vector<Vec<D>> b(3), without(3);
  points->body_force(0.1, ids, places_of(ids, X), b.data());
  points->body_force(0.1, ids, {}, without.data());
  EXPECT_EQ(b, without);
}

TYPED_TEST(Solution, PointwiseServesAnyTimeAlikeWhicheverIsPrepared) {
  constexpr int D = TypeParam::dimension;
  const TypeParam sample = samples<TypeParam>().front();
  const auto closed = sample.closed();
  const auto X = sample.points();
  const auto points = closed.at_points(X), never_prepared = closed.at_points(X);
  std::vector<std::uint32_t> ids(X.size());
  std::iota(ids.begin(), ids.end(), 0U);
  std::vector<Vec<D>> b(X.size()), expected(X.size());
  for (const double prepared : {0.1, 0.4, 0.1}) {
    points->prepare(prepared * sample.period());
    for (const double phase : {0.1, 0.4}) {
      points->body_force(phase * sample.period(), ids, X, b.data());
      never_prepared->body_force(phase * sample.period(), ids, X, expected.data());
      EXPECT_EQ(b, expected) << "at " << phase << " with " << prepared << " prepared";
    }
  }
}

TYPED_TEST(Solution, PointwiseServesThreadsAtDifferentTimes) {
  constexpr int D = TypeParam::dimension;
  const TypeParam sample = samples<TypeParam>().front();
  const auto closed = sample.closed();
  const auto all = sample.points();
  const std::vector<Vec<D>> X{all[1], all[all.size() - 3]};
  const auto points = closed.at_points(X);
  const auto work = [&](double phase, double& worst) {
    const std::vector<std::uint32_t> ids{1, 0};
    const auto places = places_of(ids, X);
    Vec<D> b[2];
    for (int k = 0; k < 2000; ++k) {
      const double t = (phase + k % 7) * sample.period();
      points->body_force(t, ids, places, b);
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

}  // namespace solutions_test
}  // namespace mpmvv::mms
