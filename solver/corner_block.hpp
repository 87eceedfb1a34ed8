#pragma once
#include <Eigen/LU>
#include <algorithm>

#include "solver/basis/basis.hpp"
#include "solver/block.hpp"
#include "solver/corner_stencil.hpp"
#include "solver/fault.hpp"
#include "solver/grid.hpp"
#include "solver/particles.hpp"

namespace mpmvv::solver {

/// Fewer particles than others have: with their corners all of a block stays near.
template <int D>
inline constexpr int corner_block_size = std::min(256 >> D, block_size<D>);

/// `value` moved into [least, most], a NaN to `least`; counts in `strays` those that had to be moved.
inline double confined(double value, double least, double most, int& strays) {
  const double inside = std::min(std::max(least, value), most);
  strays += inside == value ? 0 : 1;
  return inside;
}

/// A block with the nodes that the corners of each particle's domain reach; a `CornerStencil` puts them together.
template <int D, int K, Evaluates evaluates = Evaluates::weights_and_gradients>
struct CornerBlock : Block<D> {
  static constexpr int corners = CornerStencil<D, K>::corners;
  static constexpr int most = corner_block_size<D>;  ///< particles
  int node[corners][D][corner_block_size<D>];        ///< first node along each axis
  int first[corners][corner_block_size<D>];          ///< its storage index
  double S[corners][D][K][corner_block_size<D>];     ///< weights per axis
  Mat<D> slope[corner_block_size<D>];                ///< 2^(1-D) R^-T, per length

  CornerStencil<D, K> stencil(int k, const Grid<D>& grid) const {
    CornerStencil<D, K> s;
    for (int c = 0; c < corners; ++c) {
      s.at[c].first = static_cast<std::size_t>(first[c][k]);
      for (int d = 0; d < D; ++d) {
        s.at[c].stride[static_cast<std::size_t>(d)] = grid.stride(d);
        for (int i = 0; i < K; ++i) s.at[c].N[d][i] = S[c][d][i][k];
      }
    }
    if constexpr (evaluates == Evaluates::weights_and_gradients) s.slope.template topRows<D>() = slope[k];
    return s;
  }
};

/// Evaluates the basis at the corners of the domains of a block's particles. Faults as for a block of points; a corner
/// more than `domain_reach` cells from its particle is one, too.
template <int D, class B, Evaluates evaluates>
Fault evaluate_stencils(const B& basis, const Particles<D>& particles, const Grid<D>& grid,
                        CornerBlock<D, B::support, evaluates>& block) {
  using Corners = CornerStencil<D, B::support>;
  const double inverse_h = 1 / grid.h();
  const int count = block.count;
  const Vec<D>* x = &particles.x[block.begin];
  const Mat<D>* R = &particles.R[block.begin];
  int outside = 0, outgrown = 0;
  for (auto& first : block.first) std::fill_n(first, count, grid.node({}));
  for (int d = 0; d < D; ++d) {
    const double lower = grid.lower()[d];
    const int cells = grid.cells()[d], stride = grid.stride(d);
    const double least = 1 + domain_reach - B::ghost, most = std::nextafter(cells - least, 0.0);
    double centre[corner_block_size<D>], half[D][corner_block_size<D>];
    for (int k = 0; k < count; ++k) {
      centre[k] = confined((x[k][d] - lower) * inverse_h, least, most, outside);
      double extent = 0;
      for (int e = 0; e < D; ++e) extent += std::abs(R[k](d, e)) / 2;
      const bool fits = extent <= domain_reach;
      outgrown += fits ? 0 : 1;
      for (int e = 0; e < D; ++e) half[e][k] = fits ? R[k](d, e) / 2 : 0;
    }
    for (int c = 0; c < Corners::corners; ++c)
      for (int k = 0; k < count; ++k) {
        double xi = centre[k];
        for (int e = 0; e < D; ++e) xi += Corners::sign(c, e) * half[e][k];
        double N[B::support], dN[B::support];
        block.node[c][d][k] = basis.evaluate({xi, cells, 0}, N, dN);
        block.first[c][k] += stride * block.node[c][d][k];
        for (int i = 0; i < B::support; ++i) block.S[c][d][i][k] = N[i];
      }
  }
  if constexpr (evaluates == Evaluates::weights_and_gradients) {
    const double factor = 2 * inverse_h / Corners::corners;
    for (int k = 0; k < count; ++k) block.slope[k] = factor * R[k].inverse().transpose();
  }
  return (outside > 0 ? Fault::outside : Fault::none) | (outgrown > 0 ? Fault::outgrown : Fault::none);
}

template <int D, class B, Evaluates evaluates>
Fault set_up(const B& basis, const Particles<D>& particles, const Grid<D>& grid,
             CornerBlock<D, B::support, evaluates>& block) {
  block.in_companies = false;
  return evaluate_stencils(basis, particles, grid, block);
}

}  // namespace mpmvv::solver
