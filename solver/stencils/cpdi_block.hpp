#pragma once
#include <algorithm>

#include "solver/grid.hpp"
#include "solver/stencils/block.hpp"
#include "solver/stencils/cpdi_stencil.hpp"

namespace mpmvv::solver {

/// The most particles in a block of particles with domains. In space they are fewer than in other blocks: each particle
/// has the nodes of 2^D corners, and the whole block should fit in the nearest cache.
template <int D>
inline constexpr int cpdi_block_size = std::min(256 >> D, block_size<D>);

/// A block with the nodes that the corners of each particle's domain reach; a `CpdiStencil` puts them together.
template <int D, int K>
struct CpdiBlock : Block<D> {
  static constexpr int corners = CpdiStencil<D, K>::corners;
  static constexpr int most = cpdi_block_size<D>;  ///< the most particles that a block holds
  static_assert(has_room_for_packs(most));

  using Block<D>::Block;

  int node[corners][D][most];              ///< index along each axis of the first node that a corner reaches
  int first[corners][most];                ///< storage index of that node
  double S[corners][D][K][most];           ///< weights N_i(x_c), per axis
  PaddedMat<D> slope[cpdi_block_size<D>];  ///< 2^(1-D) R^-T, per length, set if a kernel of the sweep uses gradients

  /// Returns the stencil of the k-th particle.
  template <bool with_gradients = true>
  CpdiStencil<D, K> stencil(int k, const Grid<D>& grid) const {
    CpdiStencil<D, K> s;
    for (int c = 0; c < corners; ++c) {
      s.at[c].first = static_cast<std::size_t>(first[c][k]);
      for (int d = 0; d < D; ++d) {
        s.at[c].stride[static_cast<std::size_t>(d)] = grid.stride(d);
        for (int i = 0; i < K; ++i) s.at[c].N[d][i] = S[c][d][i][k];
      }
    }
    if constexpr (with_gradients) s.slope = slope[k];
    return s;
  }
};

}  // namespace mpmvv::solver
