#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "solver/basis/basis.hpp"
#include "solver/fault.hpp"
#include "solver/grid.hpp"
#include "solver/particles.hpp"
#include "solver/stencil.hpp"

namespace mpmvv::solver {

template <int D>
inline constexpr int block_size = 256 >> D;

/// A few neighbouring particles, and what the stages of a sweep hand to each other.
template <int D>
struct Block {
  int slab;
  std::size_t begin;
  int count;
  PackedMat<D> tau[block_size<D>];  ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size<D>];          ///< body acceleration, by EvaluateBodyForce
};

/// What a sweep evaluates at its particles' nodes: many operations use no gradients.
enum class Evaluates { weights, weights_and_gradients };

/// A block with the nodes that each of its particles reaches. Weights and gradients are kept per axis; a `Stencil`
/// forms their products.
template <int D, int K, Evaluates evaluates = Evaluates::weights_and_gradients>
struct PointBlock : Block<D> {
  int first[block_size<D>];        ///< storage index of the first node
  double N[D][K][block_size<D>];   ///< weights
  double dN[D][K][block_size<D>];  ///< gradients, per length

  auto stencil(int k, const Grid<D>& grid) const {
    constexpr bool gradients = evaluates == Evaluates::weights_and_gradients;
    std::conditional_t<gradients, Stencil<D, K>, Weights<D, K>> s;
    s.first = static_cast<std::size_t>(first[k]);
    for (int d = 0; d < D; ++d) {
      s.stride[static_cast<std::size_t>(d)] = grid.stride(d);
      for (int i = 0; i < K; ++i) {
        s.N[d][i] = N[d][i][k];
        if constexpr (gradients) s.dN[d][i] = dN[d][i][k];
      }
    }
    return s;
  }
};

/// `value` moved into [least, most], a NaN to `least`; counts in `strays` those that had to be moved.
inline double confined(double value, double least, double most, int& strays) {
  const double inside = std::min(std::max(least, value), most);
  strays += inside == value ? 0 : 1;
  return inside;
}

/// Evaluates the stencils of a block at its particles' positions. A particle out of reach of the grid, or a NaN, is
/// a fault; its stencil then lies somewhere inside storage, and the caller stops the run.
template <int D, class B, Evaluates evaluates>
Fault evaluate_stencils(const B& basis, const Particles<D>& particles, const Grid<D>& grid,
                        PointBlock<D, B::support, evaluates>& block) {
  const double inverse_h = 1 / grid.h();
  const int count = block.count;
  int outside = 0, outgrown = 0;
  std::fill_n(block.first, count, grid.node({}));
  for (int d = 0; d < D; ++d) {
    const double lower = grid.lower()[d];
    const int cells = grid.cells()[d], stride = grid.stride(d);
    const double least = B::ghost == 0 ? 0 : std::max(1, (B::support - 1) / 2) - B::ghost;
    const double most = B::ghost == 0 ? cells : std::nextafter(cells - least, 0.0);
    const Vec<D>* x = &particles.x[block.begin];
    double width[block_size<D>] = {};
    if constexpr (B::width != ParticleWidth::none) {
      const Vec<D>* l = &particles.l[block.begin];
      for (int k = 0; k < count; ++k) width[k] = confined(l[k][d], std::numeric_limits<double>::min(), 1, outgrown);
    }
    for (int k = 0; k < count; ++k) {
      const double xi = confined((x[k][d] - lower) * inverse_h, least, most, outside);
      double N[B::support], dN[B::support];
      block.first[k] += stride * basis.evaluate({xi, cells, width[k]}, N, dN);
      for (int i = 0; i < B::support; ++i) {
        block.N[d][i][k] = N[i];
        if constexpr (evaluates == Evaluates::weights_and_gradients) block.dN[d][i][k] = dN[i] * inverse_h;
      }
    }
  }
  return (outside > 0 ? Fault::outside : Fault::none) | (outgrown > 0 ? Fault::outgrown : Fault::none);
}

}  // namespace mpmvv::solver
