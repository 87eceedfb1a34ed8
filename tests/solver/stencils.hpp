#pragma once
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <type_traits>
#include <variant>
#include <vector>

#include "solver/basis/bases.hpp"
#include "solver/stencils/any_block.hpp"
#include "solver/stencils/evaluate_domains.hpp"
#include "solver/stencils/evaluate_points.hpp"
#include "solver/stencils/sweep.hpp"

/// Bases as the solver sees them: through the stencil of one particle on a grid.
namespace mpmvv::solver {

/// Every dimension.
template <int D>
using Dimension = std::integral_constant<int, D>;
using TestedDimensions = ::testing::Types<Dimension<1>, Dimension<2>, Dimension<3>>;

/// A basis with the width of the particle that is looked at, and whether its domain is sheared and turned.
struct Setting {
  AnyBasis basis;
  double width;
  bool sheared = false;
};

/// Edges of a domain, in units of its width.
template <int D>
Mat<D> domain_shape(bool sheared) {
  Mat<3> turned;
  turned << 0.8, 0.52, -0.45, -0.6, 0.7, 0.3, 0.2, -0.4, 0.9;
  if (!sheared) return Mat<D>::Identity();
  return turned.topLeftCorner<D, D>();
}

/// The settings to try a basis with: its widths, or its smoothing lengths, where it has any. With a narrow domain
/// gradients are small differences over a small width: the narrowest has a tenth of a cell.
std::vector<Setting> settings(const AnyBasis& basis, double least_width = 1e-6);

template <int D>
struct Reached {
  Index<D> node;
  Vec<D> x;  ///< position of the degree of freedom
  double N;
  Vec<D> dN;
};

template <class B, int D>
Grid<D> grid_for(const Vec<D>& lower, double h, const Index<D>& cells) {
  return Grid<D>(lower, h, cells, B::extra_inside, B::ghost);
}

template <int D>
Grid<D> grid_for(const AnyBasis& basis, const Vec<D>& lower, double h, const Index<D>& cells) {
  return std::visit([&]<class B>(const B&) { return grid_for<B, D>(lower, h, cells); }, basis);
}

/// Calls visit(n, N, ∇N) for every node of the block's first particle.
template <int D, int K, class Visit>
void for_nodes(const PointBlock<D, K>& block, const Particles<D>&, const Grid<D>& grid, const Visit& visit) {
  for (int total = static_cast<int>(std::pow(K, D)), k = 0; k < total; ++k) {
    auto n = static_cast<std::ptrdiff_t>(block.first[0]);
    double N = 1;
    Vec<D> dN = Vec<D>::Ones();
    for (int d = 0, rest = k; d < D; ++d, rest /= K) {
      const int i = rest % K;
      n += i * grid.stride(d);
      N *= block.N[d][i][0];
      for (int e = 0; e < D; ++e) dN[e] *= d == e ? block.dN[d][i][0] : block.N[d][i][0];
    }
    visit(n, N, dN);
  }
}

/// The same for CPDI, where a node comes once for each corner that reaches it, with that corner's part.
template <int D, int K, class Visit>
void for_nodes(const CpdiBlock<D, K>& block, const Particles<D>& particles, const Grid<D>& grid, const Visit& visit) {
  for (int c = 0; c < 1 << D; ++c) {
    PointBlock<D, K> corner(0);
    std::copy(block.first[c], block.first[c] + 1, corner.first);
    for (int d = 0; d < D; ++d)
      for (int i = 0; i < K; ++i) corner.N[d][i][0] = block.S[c][d][i][0], corner.dN[d][i][0] = 0;
    Vec<D> s;
    for (int d = 0; d < D; ++d) s[d] = (c >> d) % 2 == 0 ? -1 : 1;
    const Vec<D> slope = 2 / grid.h() * particles.R[0].transpose().inverse() * s;
    for_nodes(corner, particles, grid,
              [&](std::ptrdiff_t n, double S, const Vec<D>&) { visit(n, S / (1 << D), Vec<D>(S / (1 << D) * slope)); });
  }
}

/// A node that a particle reaches, by its place in storage.
template <int D>
struct Weight {
  std::size_t n;
  double N;
  Vec<D> dN;
};

/// What the only particle reaches, by what the solver has compiled for the bases; a node comes as `for_nodes` visits
/// it. Here and in `reached` the test fails where a node is outside the grid's storage.
template <int D>
std::vector<Weight<D>> weights_of_one(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid,
                                      Fault& found);

/// What a particle at x reaches.
template <int D>
std::vector<Reached<D>> reached(const Setting& setting, const Grid<D>& grid, const Vec<D>& x, Fault* fault = nullptr);

/// Distances from the lower face, in cells, that cover a line of cells: nodes, middles, quarters, both faces, and
/// random ones in between.
inline std::vector<double> places(int cells) {
  std::vector<double> xi;
  for (int k = 0; k <= 4 * cells; ++k) xi.push_back(0.25 * k);
  std::mt19937 random(7);
  for (int k = 0; k < 8 * cells; ++k) xi.push_back(std::uniform_real_distribution<double>(0, cells)(random));
  return xi;
}

}  // namespace mpmvv::solver
