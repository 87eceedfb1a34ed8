#include <cmath>

#include "tests/numbers.hpp"
#include "tests/solver/each_basis.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::basis_test {

constexpr double h = 0.125;

/// Every property is asked of every basis of the solver; a new one is covered as soon as it is named.
class BasisProperties : public WithEachBasis {
 protected:
  /// Calls check(setting, grid, x) at many places of lines, squares and cubes of few and of many cells.
  void everywhere(const auto& check, double least_width = 1e-6) const {
    for (const auto& setting : settings(basis, least_width)) {
      for (const int cells : {1, 2, 3, 4, 9}) in_dimension<1>(setting, cells, check);
      for (const int cells : {1, 3}) in_dimension<2>(setting, cells, check);
      in_dimension<3>(setting, 2, check);
    }
  }

 private:
  template <int D>
  static void in_dimension(const Setting& setting, int cells, const auto& check) {
    Index<D> count;
    count.fill(cells);
    const auto grid = grid_for<D>(setting.basis, Vec<D>::Constant(-0.25), h, count);
    const auto xi = places(cells);
    for (std::size_t k = 0; k < xi.size(); ++k) {
      Vec<D> x;
      for (std::size_t d = 0; d < D; ++d) x[static_cast<int>(d)] = -0.25 + h * xi[(k * (d + 1) + 5 * d) % xi.size()];
      check(setting, grid, x);
    }
  }
};
INSTANTIATE_TEST_SUITE_P(, BasisProperties, every_basis(), word_in_name);

/// Of a sum of terms of size one, each rounded once.
double round_off(const auto& terms) {
  return std::numeric_limits<double>::epsilon() * static_cast<double>(terms.size());
}

TEST_P(BasisProperties, WeightsSumToOne) {
  everywhere([](const auto& setting, const auto& grid, const auto& x) {
    double sum = 0;
    const auto nodes = reached(setting, grid, x);
    for (const auto& node : nodes) sum += node.N;
    EXPECT_NEAR(sum, 1, round_off(nodes));
  });
}

TEST_P(BasisProperties, WeightsAreNotNegative) {
  everywhere([](const auto& setting, const auto& grid, const auto& x) {
    for (const auto& node : reached(setting, grid, x)) EXPECT_GE(node.N, -1e-17);
  });
}

TEST_P(BasisProperties, GradientsSumToZero) {
  everywhere([](const auto& setting, const auto& grid, const auto& x) {
    auto sum = (0 * x).eval();
    double largest = 0;
    const auto nodes = reached(setting, grid, x);
    for (const auto& node : nodes) sum += node.dN, largest = std::max(largest, node.dN.norm());
    EXPECT_LT(sum.norm(), std::max(1e-14 / h, round_off(nodes) * largest));
  });
}

TEST_P(BasisProperties, ReproducesPositions) {  // Σ_i N_i x_i = x
  everywhere([](const auto& setting, const auto& grid, const auto& x) {
    auto sum = (0 * x).eval();
    const auto nodes = reached(setting, grid, x);
    for (const auto& node : nodes) sum += node.N * node.x;
    EXPECT_LT((sum - x).norm(), round_off(nodes)) << x.transpose();
  });
}

TEST_P(BasisProperties, ReproducesUnitGradient) {  // Σ_i x_i ⊗ ∇N_i = I; catches a sign that Σ∇N = 0 cannot see
  everywhere([]<int D>(const auto& setting, const Grid<D>& grid, const Vec<D>& x) {
    Mat<D> sum = Mat<D>::Zero();
    for (const auto& node : reached(setting, grid, x)) sum += node.x * node.dN.transpose();
    EXPECT_LT((sum - Mat<D>::Identity()).norm(), 1e-13) << x.transpose();
  });
}

/// Weights and gradients by node, zero where the particle does not reach.
template <int D>
struct Field {
  double N = 0;
  Vec<D> dN = Vec<D>::Zero();
};
template <int D>
std::map<Index<D>, Field<D>> by_node(const Setting& setting, const Grid<D>& grid, const Vec<D>& x) {
  std::map<Index<D>, Field<D>> nodes;
  for (const auto& node : reached(setting, grid, x)) {
    auto& [N, dN] = nodes[node.node];
    N += node.N, dN += node.dN;
  }
  return nodes;
}

TEST_P(BasisProperties, GradientIsTheDerivativeOfTheWeight) {
  if (width_of(basis) == ParticleWidth::domain) GTEST_SKIP() << "it is a mean over the domain";
  const double step = 1e-7;  // in cells
  std::mt19937 random(3);
  for (const auto& setting : settings(basis, 0.05))
    for (const int cells : {1, 2, 3, 9}) {
      const auto grid = grid_for<2>(basis, Vec<2>::Zero(), h, {cells, cells});
      std::uniform_real_distribution<double> inside(0.001, cells - 0.001);
      for (int trial = 0; trial < 100; ++trial) {
        const Vec<2> x = h * Vec<2>(inside(random), inside(random));
        for (int d = 0; d < 2; ++d) {
          const Vec<2> shift = step * h * Vec<2>::Unit(d);
          auto right = by_node(setting, grid, Vec<2>(x + shift)), left = by_node(setting, grid, Vec<2>(x - shift));
          for (const auto& node : reached(setting, grid, x))
            EXPECT_NEAR((right[node.node].N - left[node.node].N) / (2 * step), h * node.dN[d], 2e-6);
        }
      }
    }
}

TEST_P(BasisProperties, ContinuousAcrossCellFaces) {
  const double step = 1e-10;
  const bool smooth = !std::holds_alternative<Linear>(basis);
  const int cells = 6;
  const int extra = std::visit([]<class B>(const B&) { return B::extra_inside; }, basis);
  const int last = cells + extra + ghosts_of(basis);
  const auto grid = grid_for<1>(basis, Vec<1>::Zero(), 1, {cells});
  for (const auto& setting : settings(basis, 0.01))
    for (int half = 1; half < 2 * cells; ++half) {
      auto left = by_node(setting, grid, Vec<1>(0.5 * half - step));
      auto right = by_node(setting, grid, Vec<1>(0.5 * half + step));
      for (int i = -ghosts_of(basis); i < last; ++i) {
        EXPECT_NEAR(left[{i}].N, right[{i}].N, 4 * step);
        EXPECT_NEAR(left[{i}].dN[0], right[{i}].dN[0], smooth ? 500 * step : 2);
      }
    }
}

TEST_P(BasisProperties, ReachesOnlyStorage) {
  const int ghost = ghosts_of(basis), support = std::visit([]<class B>(const B&) { return B::support; }, basis);
  const double far = 0.5 * ghost + 3;
  const int either_side = std::max(1, (support - 1) / 2);  // nodes that reach a point
  for (const auto& setting : settings(basis))
    for (const int cells : {1, 2, 5}) {
      const auto grid = grid_for<2>(basis, Vec<2>::Zero(), h, {cells, cells});
      for (double xi = -far; xi <= cells + far; xi += 0.25) {
        const double stray = ghost == 0 ? 0 : ghost - either_side - reach(width_of(basis));
        Fault fault;
        reached(setting, grid, Vec<2>(h * xi, h * (cells - xi)), &fault);  // fails where a node is outside storage
        const bool inside =
            xi >= -stray && xi <= cells + stray && (stray == 0 || std::abs(2 * xi - cells) < cells + 2 * stray);
        EXPECT_EQ(fault, inside ? Fault::none : Fault::outside) << xi;
      }
      for (const double x : {nan, infinity, -infinity, 1e300, -1e300}) {
        Fault fault;
        reached(setting, grid, Vec<2>(0.5 * h, x), &fault);
        EXPECT_EQ(fault, Fault::outside) << x;
      }
    }
}

TEST_P(BasisProperties, RefusesWidthsBeyondACell) {
  if (width_of(basis) == ParticleWidth::none || width_of(basis) == ParticleWidth::domain)
    GTEST_SKIP() << "a particle has no width along the axes";
  const auto grid = grid_for<1>(basis, Vec<1>::Zero(), h, {4});
  for (const double width : {1.0000001, 0.0, -0.1, nan, infinity}) {
    Fault fault;
    reached(Setting{basis, width}, grid, Vec<1>(0.2), &fault);
    EXPECT_EQ(fault, Fault::outgrown) << width;
  }
}

}  // namespace mpmvv::solver::basis_test
