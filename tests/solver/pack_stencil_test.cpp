#include "solver/stencils/pack_stencil.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace mpmvv::solver::pack_stencil_test {

/// Four particles of a bar in the middle of a block, whose first nodes lie so far behind the first one's. The weights
/// are random: sums are the same with any.
template <int K>
struct Four {
  static constexpr int place = 8;
  Grid<1> grid{Vec<1>(0), 1, {20}, 1, 2};
  PointBlock<1, K> block{0};
  std::mt19937 random{7};

  explicit Four(const std::array<int, 4>& behind) {
    block.begin = 0, block.count = PointBlock<1, K>::most;
    for (int k = 0; k < block.count; ++k) {
      const int lane = k - place;
      block.first[k] = 9 + (lane >= 0 && lane < 4 ? behind[static_cast<std::size_t>(lane)] : 0);
      for (int i = 0; i < K; ++i) block.N[0][i][k] = any(), block.dN[0][i][k] = any();
    }
  }
  double any() { return std::uniform_real_distribution<double>(-1, 1)(random); }

  Stencil<1, K> stencil(int lane) const { return block.template stencil<true>(place + lane, grid); }
  bool reaches(int lane, std::size_t node) const {
    return node >= stencil(lane).first && node < stencil(lane).first + K;
  }
  bool one_reaches(std::size_t node) const {
    return reaches(0, node) || reaches(1, node) || reaches(2, node) || reaches(3, node);
  }
  /// Calls check(nodes) with those of the four; whether they are taken together.
  bool visit(const auto& check) const { return visit_together<true>(block, place, check); }
};

/// Values on nodes, and NaN where none of the four reaches them.
template <int K>
Array<Padded<1>> some_field(Four<K>& four) {
  Array<Padded<1>> field(four.grid.size());
  for (std::size_t n = 0; n < field.size(); ++n) field[n][0] = four.one_reaches(n) ? four.any() : std::nan("");
  return field;
}

template <int K>
void expect_sums_over_nodes(Four<K> four) {
  const auto field = some_field(four);
  EXPECT_TRUE(four.visit([&](const auto& nodes) {
    const PackVec<1> value = nodes.gather(field);
    const auto both = nodes.gather_with_gradient(field);
    for (int lane = 0; lane < 4; ++lane) {
      const auto alone = four.stencil(lane).gather_with_gradient(field);
      const auto k = static_cast<std::size_t>(lane);
      EXPECT_NEAR(value[0][k], alone.value[0], 1e-15) << lane;
      EXPECT_NEAR(both.value[0][k], alone.value[0], 1e-15) << lane;
      EXPECT_NEAR(both.gradient[0][k], alone.gradient[0], 1e-15) << lane;
    }
  }));
}

/// Where none of the four reaches a node it keeps its -0, which the addition of a zero would turn into a zero: it may
/// belong to another thread.
template <int C, int K>
void expect_same_fields(const Four<K>& four, const auto& together, const auto& one_by_one) {
  for (std::size_t n = 0; n < together.size(); ++n)
    for (int c = 0; c < C; ++c) {
      EXPECT_NEAR(together[n][c], one_by_one[n][c], 1e-15) << n;
      if (!four.one_reaches(n)) {
        EXPECT_TRUE(std::signbit(together[n][c])) << n;
      }
    }
}

template <int K>
void expect_sums_over_particles(Four<K> four) {
  std::array<Padded<2>, 4> momentum;
  std::array<ValueAndGradient<1>, 4> force;
  PackVec<2> momenta;
  ValueAndGradient<1, Pack> forces;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    momentum[lane] = {four.any(), four.any()};
    force[lane] = {Padded<1>(four.any()), PaddedMat<1>(four.any())};
    for (int c = 0; c < 2; ++c) momenta[c].of[lane] = momentum[lane][c];
    forces.value[0].of[lane] = force[lane].value[0], forces.gradient[0].of[lane] = force[lane].gradient[0];
  }
  Array<Padded<2>> p(four.grid.size(), Padded<2>::Constant(-0.)), p_alone = p;
  Array<Padded<1>> f(four.grid.size(), Padded<1>(-0.)), f_alone = f;
  for (int lane = 0; lane < 4; ++lane) {
    four.stencil(lane).scatter(momentum[static_cast<std::size_t>(lane)], p_alone);
    four.stencil(lane).scatter(force[static_cast<std::size_t>(lane)], f_alone);
  }
  EXPECT_TRUE(four.visit([&](const auto& nodes) { nodes.scatter(momenta, p), nodes.scatter(forces, f); }));
  expect_same_fields<2>(four, p, p_alone);
  expect_same_fields<1>(four, f, f_alone);
}

template <int K>
void expect_as_one_by_one() {
  for (const std::array<int, 4>& behind :
       {std::array{0, 0, 0, 0}, {0, 0, 0, 1}, {0, 1, 1, 1}, {0, 0, 1, 2}, {0, 2, 2, 2}, {0, 2, 1, 0}}) {
    expect_sums_over_nodes<K>(Four<K>(behind));
    expect_sums_over_particles<K>(Four<K>(behind));
  }
}

TEST(PackStencils, SumAsFourStencilsDo) {
  expect_as_one_by_one<2>();
  expect_as_one_by_one<3>();
  expect_as_one_by_one<4>();
  expect_as_one_by_one<5>();
}

TEST(PackStencils, AreNotForParticlesFarApartOrBeforeTheFirst) {
  for (const std::array<int, 4>& behind : {std::array{0, 1, 2, 3}, {0, 0, 0, -1}, {0, -2, 0, 1}, {0, 3, 0, 0}})
    EXPECT_FALSE(Four<3>(behind).visit([](const auto&) { FAIL(); }));
}

}  // namespace mpmvv::solver::pack_stencil_test
