#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <thread>
#include <variant>

#include "tests/mms/differences.hpp"
#include "tests/mms/samples.hpp"

namespace mpmvv::mms::solutions_test {

/// A sample whose type is forgotten: what the tests ask of it is compiled once in each dimension.
template <int D>
struct Motion {
  std::shared_ptr<const ManufacturedSolution<D>> closed;
  std::shared_ptr<const ManufacturedSolution<D>> by_derivation;
  std::function<std::array<double, D>(const std::array<double, D>&, double)> displacement;
  Elasticity material;
  double period;
  std::vector<Vec<D>> points;
  Piece<D> piece;

  double reach() const { return closed->displacement_scale(); }  ///< how far it goes
  double rate() const { return 2 * M_PI / period; }              ///< how fast its phase grows
};
using Motions = std::variant<std::vector<Motion<1>>, std::vector<Motion<2>>, std::vector<Motion<3>>>;

template <class S>
Motions motions() {
  constexpr int D = S::dimension;
  const auto shared = []<class T>(const T& solution) { return std::make_shared<const T>(solution); };
  std::vector<Motion<D>> all;
  for (const S& sample : samples<S>()) {
    const auto closed = shared(sample.closed());
    all.push_back({closed, shared(derived<D>(sample.displacement(), sample.material, closed->displacement_scale())),
                   sample.displacement(), sample.material, sample.period(), sample.points(), sample.piece()});
  }
  return all;
}

struct Named {
  const char* name;
  Motions (*motions)();
};

class Solution : public ::testing::TestWithParam<Named> {
 protected:
  template <class Check>
  static void each(const Check& check) {
    std::visit(
        [&](const auto& all) {
          for (const auto& motion : all) check(motion);
        },
        GetParam().motions());
  }

  /// At times over the period.
  template <class Check>
  static void everywhere(const Check& check) {
    each([&](const auto& motion) {
      for (const double phase : {0.0, 0.125, 0.25, 0.4, 0.5, 0.75, 0.81, 1.0})
        for (const auto& X : motion.points) check(motion, X, phase * motion.period);
    });
  }
};

constexpr Named all_solutions[]{{"Bar", &motions<BarSample>},
                                {"Square", &motions<SquareSample>},
                                {"Cube", &motions<CubeSample>},
                                {"BarAtRest", &motions<BarAtRestSample>},
                                {"SquareAtRest", &motions<SquareAtRestSample>},
                                {"CubeAtRest", &motions<CubeAtRestSample>},
                                {"SquareInverse", &motions<SquareInverseSample>},
                                {"Ring", &motions<RingSample>},
                                {"Shell", &motions<ShellSample>},
                                {"Vortex", &motions<VortexSample>}};
INSTANTIATE_TEST_SUITE_P(All, Solution, ::testing::ValuesIn(all_solutions),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// The places of the points with these ids.
template <int D>
std::vector<Vec<D>> places_of(const std::vector<std::uint32_t>& ids, const std::vector<Vec<D>>& X) {
  std::vector<Vec<D>> places;
  for (const auto id : ids) places.push_back(X[id]);
  return places;
}

/// The ids of so many points.
std::vector<std::uint32_t> first_ids(std::size_t count) {
  std::vector<std::uint32_t> ids(count);
  std::iota(ids.begin(), ids.end(), 0U);
  return ids;
}

/// X-derive: every closed form equals the one derived from the displacement alone.
TEST_P(Solution, ClosedFormsEqualDerivedOnes) {
  everywhere([]<int D>(const Motion<D>& m, const Vec<D>& X, double t) {
    const ManufacturedSolution<D>&closed = *m.closed, &by_derivation = *m.by_derivation;
    const double A = m.reach(), w = m.rate(), E = m.material.youngs_modulus;
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
TEST_P(Solution, BalancesMomentum) {
  everywhere([]<int D>(const Motion<D>& m, const Vec<D>& X, double t) {
    const Differences<D, double, decltype(m.displacement)> expected{m.displacement, m.material, 1e-3, 1e-3 * m.period};
    const Vec<D> b = m.closed->b(X, t);
    EXPECT_LT((b - expected.b(X, t)).norm(), 1e-5 * (m.reach() * m.rate() * m.rate() + b.norm())) << X.transpose();
  });
}

/// ∫ρ₀ b dV + ∮ P N dA = ∫ρ₀ a dV
TEST_P(Solution, BalancesForcesOnAPiece) {
  each([](const auto& m) {
    for (const double phase : {0.15, 0.3, 0.67})
      EXPECT_LT(imbalance(*m.closed, m.material.density, m.piece, phase * m.period), 1e-12);
  });
}

/// P Fᵀ = J σ is symmetric.
TEST_P(Solution, BalancesAngularMomentum) {
  everywhere([]<int D>(const Motion<D>& m, const Vec<D>& X, double t) {
    const Mat<D> tau = m.closed->P(X, t) * m.closed->F(X, t).transpose();
    EXPECT_LT((tau - tau.transpose()).norm(), 1e-14 * m.material.youngs_modulus);
  });
}

TEST_P(Solution, ReferencePointInvertsTheMotion) {
  everywhere([]<int D>(const Motion<D>& m, const Vec<D>& X, double t) {
    EXPECT_LT((m.closed->reference_point(X + m.closed->u(X, t), t) - X).norm(), 1e-13);
  });
}

/// The largest displacement over body and time, up to a factor of order one.
TEST_P(Solution, KnowsHowFarItGoes) {
  each([](const auto& m) {
    double largest = 0;
    for (const double phase : {0.0, 0.25, 0.5})
      for (const auto& X : m.points) largest = std::max(largest, m.closed->u(X, phase * m.period).norm());
    EXPECT_GT(largest, m.reach() / 2);
    EXPECT_LT(largest, m.reach() * 2);
  });
}

/// For any number of points in any order, some of them twice.
TEST_P(Solution, PointwiseEqualsDirect) {
  each([]<int D>(const Motion<D>& m) {
    const double t = 0.3 * m.period;
    std::vector<Vec<D>> X;
    for (std::size_t k = 0; k < 100; ++k) X.push_back(m.points[k * 7 % m.points.size()]);
    const auto points = m.closed->at_points(X);
    for (const std::uint32_t count : {0U, 1U, 31U, 32U, 33U, 71U}) {
      std::vector<std::uint32_t> ids;
      for (std::uint32_t k = 0; k < count; ++k) ids.push_back(99 - k % 64);
      std::vector<Vec<D>> u(count + 1, Vec<D>::Constant(-7)), b(u);
      points->displacement(t, ids, u.data());
      points->body_force(t, ids, places_of(ids, X), b.data());
      for (std::size_t k = 0; k < count; ++k) {
        const Vec<D> expected = m.closed->b(X[ids[k]], t);
        EXPECT_LT((u[k] - m.closed->u(X[ids[k]], t)).norm(), 4e-15 * m.reach());  // sines of lanes: 4 units each
        EXPECT_LT((b[k] - expected).norm(), 1e-13 * (expected.norm() + m.reach() * m.rate() * m.rate()));
      }
      EXPECT_EQ(u[count], Vec<D>::Constant(-7));
      EXPECT_EQ(b[count], Vec<D>::Constant(-7));
    }
  });
}

/// Bit for bit, whichever points are asked for with it: results do not depend on how particles are cut into blocks.
TEST_P(Solution, PointwiseDependsOnThePointAlone) {
  each([]<int D>(const Motion<D>& m) {
    const double t = 0.3 * m.period;
    const std::vector<Vec<D>>& X = m.points;
    const auto points = m.closed->at_points(X);
    const auto ids = first_ids(X.size());
    std::vector<Vec<D>> b(X.size()), u(X.size());
    points->body_force(t, ids, X, b.data());
    points->displacement(t, ids, u.data());
    for (const std::uint32_t id : ids) {
      Vec<D> alone;
      points->body_force(t, {&id, 1}, {&X[id], 1}, &alone);
      EXPECT_EQ(alone, b[id]) << X[id].transpose();
      points->displacement(t, {&id, 1}, &alone);
      EXPECT_EQ(alone, u[id]) << X[id].transpose();
    }
  });
}

/// A solution that says that it reads no places gives the same without any.
TEST_P(Solution, PointwiseReadsPlacesOnlyWhereItSaysSo) {
  each([]<int D>(const Motion<D>& m) {
    const auto points = m.closed->at_points(m.points);
    if (points->reads_places()) GTEST_SKIP() << "its body force reads the places of points";
    const std::vector<std::uint32_t> ids{2, 0, 1};
    std::vector<Vec<D>> b(3), without(3);
    points->body_force(0.1, ids, places_of(ids, m.points), b.data());
    points->body_force(0.1, ids, {}, without.data());
    EXPECT_EQ(b, without);
  });
}

TEST_P(Solution, PointwiseServesAnyTimeAlikeWhicheverIsPrepared) {
  each([]<int D>(const Motion<D>& m) {
    const std::vector<Vec<D>>& X = m.points;
    const auto points = m.closed->at_points(X), never_prepared = m.closed->at_points(X);
    const auto ids = first_ids(X.size());
    std::vector<Vec<D>> b(X.size()), expected(X.size());
    for (const double prepared : {0.1, 0.4, 0.1}) {
      points->prepare(prepared * m.period);
      for (const double phase : {0.1, 0.4}) {
        points->body_force(phase * m.period, ids, X, b.data());
        never_prepared->body_force(phase * m.period, ids, X, expected.data());
        EXPECT_EQ(b, expected) << "at " << phase << " with " << prepared << " prepared";
      }
    }
  });
}

TEST_P(Solution, PointwiseServesThreadsAtDifferentTimes) {
  each([]<int D>(const Motion<D>& m) {
    const std::vector<Vec<D>> X{m.points[1], m.points[m.points.size() - 3]};
    const auto points = m.closed->at_points(X);
    const auto work = [&](double phase, double& worst) {
      const std::vector<std::uint32_t> ids{1, 0};
      const auto places = places_of(ids, X);
      Vec<D> b[2];
      for (int k = 0; k < 2000; ++k) {
        const double t = (phase + k % 7) * m.period;
        points->body_force(t, ids, places, b);
        const Vec<D> expected = m.closed->b(X[1], t);
        worst = std::max(worst, (b[0] - expected).norm() / expected.norm());
      }
    };
    double worst[2] = {0, 0};
    std::thread other(work, 0.1, std::ref(worst[0]));
    work(0.6, worst[1]);
    other.join();
    EXPECT_LT(worst[0], 1e-12);
    EXPECT_LT(worst[1], 1e-12);
  });
}

}  // namespace mpmvv::mms::solutions_test
