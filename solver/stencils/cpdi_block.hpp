#pragma once
#include <algorithm>

#include "solver/grid.hpp"
#include "solver/stencils/block.hpp"
#include "solver/stencils/cpdi_stencil.hpp"

namespace mpmvv::solver {

/// Fewer particles than other blocks have: each has the nodes of 2^D corners, and all of a block should fit in the
/// nearest cache.
template <int D>
inline constexpr int cpdi_block_size = std::min(256 >> D, block_size<D>);

/// A block with the nodes that the corners of each particle's domain reach; a `CpdiStencil` puts them together.
template <int D, int K>
struct CpdiBlock : Block<D> {
  static constexpr int corners = CpdiStencil<D, K>::corners;
  static constexpr int most = cpdi_block_size<D>;  ///< particles
  static_assert(has_room_for_packs(most));

  using Block<D>::Block;

  int node[corners][D][most];              ///< first node along each axis
  int first[corners][most];                ///< its storage index
  double S[corners][D][K][most];           ///< weights per axis
  PaddedMat<D> slope[cpdi_block_size<D>];  ///< 2^(1-D) R^-T, per length, where a kernel of the sweep uses gradients

  /// Of the k-th particle.
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
