#pragma once
#include <type_traits>

#include "solver/grid.hpp"
#include "solver/stencils/block.hpp"
#include "solver/stencils/stencil.hpp"

namespace mpmvv::solver {

/// A block with the nodes that each of its particles reaches, K along each axis. Weights and gradients are kept per
/// axis; a `Stencil` forms their products.
template <int D, int K>
struct PointBlock : Block<D> {
  static constexpr int most = block_size<D>;  ///< the most particles that a block holds

  using Block<D>::Block;

  int first[most];                    ///< storage index of the first node
  alignas(32) double N[D][K][most];   ///< weights, per axis
  alignas(32) double dN[D][K][most];  ///< gradients, per length, set if a kernel of the sweep uses them

  /// Returns the stencil of the k-th particle, or its weights alone.
  template <bool with_gradients = true>
  auto stencil(int k, const Grid<D>& grid) const {
    std::conditional_t<with_gradients, Stencil<D, K>, Weights<D, K>> s;
    s.first = static_cast<std::size_t>(first[k]);
    for (int d = 0; d < D; ++d) {
      s.stride[static_cast<std::size_t>(d)] = grid.stride(d);
      for (int i = 0; i < K; ++i) {
        s.N[d][i] = N[d][i][k];
        if constexpr (with_gradients) s.dN[d][i] = dN[d][i][k];
      }
    }
    return s;
  }
};

}  // namespace mpmvv::solver
