#pragma once
#include <algorithm>
#include <array>

#include "solver/stencils/any_block.hpp"
#include "solver/stencils/cpdi_block.hpp"
#include "solver/stencils/point_block.hpp"

namespace mpmvv::solver {

/// The nodes that each particle of a block reaches as a box, W along each axis, with N_ip on each. Those of a line
/// along the first axis lie side by side, filled up with zeros to an even number.
template <int D, int W>
struct NodeBoxes {
  static constexpr int size = power(W, D), line = W + W % 2;

  int first[block_size<D>];  ///< storage index of the first node
  double N[block_size<D>][line * power(W, D - 1)] = {};

  /// Of the i-th node of the box.
  double& weight(std::size_t particle, int i) { return N[particle][i / W * line + i % W]; }
};

/// How many nodes wide the boxes of a block are. Those of particles with domains are one wider than the nodes of a
/// corner: enough while no two corners of a particle lie more than a cell apart along an axis.
template <class Shape>
inline constexpr int box_width = 0;
template <int D, int K>
inline constexpr int box_width<PointBlock<D, K>> = K;
template <int D, int K>
inline constexpr int box_width<CpdiBlock<D, K>> = K + 1;

/// Products of the weights per axis. True: they always fit.
template <int D, int K>
bool find_boxes(const PointBlock<D, K>& block, const Grid<D>&, NodeBoxes<D, K>& boxes) {
  std::copy_n(block.first, block.count, boxes.first);
  for (int i = 0; i < boxes.size; ++i)
    for (std::size_t k = 0; k < static_cast<std::size_t>(block.count); ++k) {
      double product = block.N[0][i % K][k];
      for (int d = 1; d < D; ++d) product *= block.N[d][i / power(K, d) % K][k];
      boxes.weight(k, i) = product;
    }
  return true;
}

namespace detail {

template <int D>
using CornerNodes = std::array<std::array<int, cpdi_block_size<D>>, D>;

/// The first node of each particle's corners along each axis; false when some reach too far for a box.
template <int D, int K>
bool find_lowest_nodes(const CpdiBlock<D, K>& block, CornerNodes<D>& lowest) {
  int too_wide = 0;
  for (std::size_t d = 0; d < D; ++d) {
    int* const least = lowest[d].data();
    std::copy_n(block.node[0][d], block.count, least);
    for (int c = 1; c < block.corners; ++c)
      for (int k = 0; k < block.count; ++k) least[k] = std::min(least[k], block.node[c][d][k]);
    for (int c = 0; c < block.corners; ++c)
      for (int k = 0; k < block.count; ++k) too_wide += block.node[c][d][k] - least[k] > 1 ? 1 : 0;
  }
  return too_wide == 0;
}

/// Weights per axis of the nodes of a box, by corner: those that a corner does not reach have none.
template <int D, int K>
using CornerWeights = std::array<std::array<std::array<std::array<double, cpdi_block_size<D>>, K + 1>, D>, 1 << D>;

template <int D, int K>
CornerWeights<D, K> spread(const CpdiBlock<D, K>& block, const CornerNodes<D>& lowest) {
  CornerWeights<D, K> S;
  for (std::size_t c = 0; c < S.size(); ++c)
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t i = 0; i <= K; ++i)
        for (std::size_t k = 0; k < static_cast<std::size_t>(block.count); ++k) {
          const double near = i < K ? block.S[c][d][i][k] : 0, far = i > 0 ? block.S[c][d][i - 1][k] : 0;
          S[c][d][i][k] = block.node[c][d][k] == lowest[d][k] ? near : far;
        }
  return S;
}

}  // namespace detail

/// The nodes of all corners put together. False, and no boxes, where those of some particle do not fit.
template <int D, int K>
bool find_boxes(const CpdiBlock<D, K>& block, const Grid<D>& grid, NodeBoxes<D, K + 1>& boxes) {
  detail::CornerNodes<D> lowest;
  if (!detail::find_lowest_nodes<D, K>(block, lowest)) return false;
  const auto count = static_cast<std::size_t>(block.count);
  for (std::size_t k = 0; k < count; ++k) {
    Index<D> node;
    for (std::size_t d = 0; d < D; ++d) node[d] = lowest[d][k];
    boxes.first[k] = grid.node(node);
  }
  const auto S = detail::spread<D, K>(block, lowest);
  for (int i = 0; i < boxes.size; ++i)
    for (std::size_t k = 0; k < count; ++k) {
      double sum = 0;
      for (const auto& corner : S) {
        double product = 1;
        for (std::size_t d = 0; d < D; ++d)
          product *= corner[d][static_cast<std::size_t>(i / power(K + 1, static_cast<int>(d)) % (K + 1))][k];
        sum += product;
      }
      boxes.weight(k, i) = sum / block.corners;
    }
  return true;
}

}  // namespace mpmvv::solver
