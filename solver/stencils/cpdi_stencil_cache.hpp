#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/stencils/cached_stencil.hpp"
#include "solver/stencils/cpdi_block.hpp"

namespace mpmvv::solver {

/// The nodes that the corners of each particle's domain reach, put together to a box with N_ip on each, and kept for a
/// step that visits them again and again. Boxes are one node wider than the nodes of a corner: enough while no two
/// corners of a particle lie more than a cell apart along an axis.
template <int D>
class CpdiStencilCache {
 public:
  /// For a basis of so many nodes to a corner.
  CpdiStencilCache(int support, std::size_t particles)
      : first_(particles), N_(particles * static_cast<std::size_t>(power(support + 1, D))) {}

  /// Whether the nodes of every particle kept since `clear` fitted into a box. If not, the cache is of no use.
  bool is_complete() const { return kept_ == first_.size(); }
  void clear() { kept_ = 0; }

  /// Of the particles of a block.
  template <int K>
  void keep(const CpdiBlock<D, K>& block, const Grid<D>& grid) {
    constexpr int size = power(K + 1, D);
    std::size_t kept = 0;
    PerAxis lowest;
    if (!find_lowest_nodes(block, lowest)) return;
    double box[size][cpdi_block_size<D>] = {};
    for (int c = 0; c < block.corners; ++c) add_corner(block, c, lowest, box);
    for_particles(block, [&](std::size_t p, int k) {
      Index<D> node;
      for (std::size_t d = 0; d < D; ++d) node[d] = lowest[d][static_cast<std::size_t>(k)];
      first_[p] = static_cast<std::uint32_t>(grid.node(node));
      for (int i = 0; i < size; ++i) N_[p * size + static_cast<std::size_t>(i)] = box[i][k];
      ++kept;
    });
    kept_ += kept;
  }

  template <int W>
  CachedStencil<D, W> stencil(std::size_t p, const Grid<D>& grid) const {
    CachedStencil<D, W> box{first_[p], {}, &N_[p * static_cast<std::size_t>(power(W, D))]};
    for (int d = 0; d < D; ++d) box.stride[static_cast<std::size_t>(d)] = grid.stride(d);
    return box;
  }

 private:
  using PerAxis = std::array<std::array<int, cpdi_block_size<D>>, D>;

  /// Of each particle's corners; false when they reach too far for a box.
  template <int K>
  static bool find_lowest_nodes(const CpdiBlock<D, K>& block, PerAxis& lowest) {
    int too_wide = 0;
    for (std::size_t d = 0; d < D; ++d) {
      int* const least = lowest[d].data();
      std::copy_n(block.node[0][d], block.places(), least);
      for (int c = 1; c < block.corners; ++c)
        for (int k = 0; k < block.places(); ++k) least[k] = std::min(least[k], block.node[c][d][k]);
      for (int c = 0; c < block.corners; ++c)
        for (int k = 0; k < block.places(); ++k) too_wide += block.node[c][d][k] - least[k] > 1 ? 1 : 0;
    }
    return too_wide == 0;
  }

  /// The corner's share of each node in the box, nodes that it does not reach having none.
  template <int K>
  static void add_corner(const CpdiBlock<D, K>& block, int c, const PerAxis& lowest,
                         double (&box)[power(K + 1, D)][cpdi_block_size<D>]) {
    constexpr int W = K + 1;
    double S[D][W][cpdi_block_size<D>];
    for (std::size_t d = 0; d < D; ++d)
      for (int i = 0; i < W; ++i)
        for (int k = 0; k < block.places(); ++k) {
          const double near = i < K ? block.S[c][d][i][k] : 0, far = i > 0 ? block.S[c][d][i - 1][k] : 0;
          S[d][i][k] = block.node[c][d][k] == lowest[d][static_cast<std::size_t>(k)] ? near : far;
        }
    for (int i = 0; i < power(W, D); ++i)
      for (int k = 0; k < block.places(); ++k) {
        double product = 1.0 / block.corners;
        for (int d = 0; d < D; ++d) product *= S[d][i / power(W, d) % W][k];
        box[i][k] += product;
      }
  }

  std::vector<std::uint32_t> first_;  ///< storage index of the first node
  std::vector<double> N_;             ///< of one particle after the other
  std::atomic<std::size_t> kept_{0};
};

}  // namespace mpmvv::solver
