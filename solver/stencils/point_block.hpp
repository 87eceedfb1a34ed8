#pragma once
#include <type_traits>

#include "solver/grid.hpp"
#include "solver/stencils/block.hpp"
#include "solver/stencils/stencil.hpp"

namespace mpmvv::solver {

/// A block with the nodes that each of its particles reaches, K along each axis. Weights and gradients are kept per
/// axis; a `Stencil` or a `PackStencil` forms their products.
template <int D, int K>
struct PointBlock : Block<D> {
  static constexpr int most = block_size<D>;  ///< places for particles

  using Block<D>::Block;

  int first[most];                    ///< storage index of the first node
  alignas(64) double N[D][K][most];   ///< weights
  alignas(64) double dN[D][K][most];  ///< gradients, per length, where a kernel of the sweep uses them

  /// Of the particle at place k.
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

/// Whether the particles of each group reach the same nodes.
template <int D, int K>
bool share_their_nodes(const PointBlock<D, K>& block) {
  LaneInts others{};
  for (int g = 0; g < block.groups; ++g)
    for (int pack = block.group[g]; pack < block.group[g + 1]; ++pack)
      others |= (load_lanes(&block.first[pack * lanes]) != block.first[block.group[g] * lanes]) &
                (lane_numbers() < block.filled[pack]);
  return !any(others);
}

/// Whether the particles of a block may be visited in packs.
template <class Shape>
inline constexpr bool has_packs = false;
template <int D, int K>
inline constexpr bool has_packs<PointBlock<D, K>> = true;

}  // namespace mpmvv::solver
