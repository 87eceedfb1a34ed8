#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

#include "solver/simd/pack.hpp"
#include "solver/stencils/cpdi_block.hpp"
#include "solver/stencils/point_block.hpp"

namespace mpmvv::solver {

/// For each particle of a block, a box of nodes, W along each axis, that holds the nodes that the particle reaches,
/// with N_ip on each. The weights of a line of nodes along the first axis lie side by side, filled up with zeros to an
/// even number.
template <int D, int W>
struct NodeBoxes {
  static constexpr int line = W + W % 2, lines = power(W, D - 1);

  int first[block_size<D>];  ///< storage index of the first node
  double N[block_size<D>][line * lines];

  /// Sets N_ip = of_node(i) for the four particles from the k-th on, where i is the index of a node in the box, by
  /// axis.
  template <class OfNode>
  [[gnu::always_inline]] void set_four(int k, const OfNode& of_node) {
    Pack four[line * lines];
    for (int j = 0; j < lines; ++j)
      for (int i = 0; i < line; ++i) four[j * line + i] = i < W ? of_node(std::array{i, j % W, j / W}) : Pack(0);
    store_packs<line * lines>(four, {N[k], N[k + 1], N[k + 2], N[k + 3]});
  }
};

/// The width of a block's boxes, in nodes. For a particle with a domain, a box is one node wider than the nodes of a
/// corner. That is enough as long as no two corners of a particle lie more than a cell apart along an axis.
template <class Shape>
inline constexpr int box_width = 0;
template <int D, int K>
inline constexpr int box_width<PointBlock<D, K>> = K;
template <int D, int K>
inline constexpr int box_width<CpdiBlock<D, K>> = K + 1;

/// Sets the boxes to the products of the weights per axis. Returns true: the nodes of points always fit.
template <int D, int K>
bool find_boxes(const PointBlock<D, K>& block, const Grid<D>&, NodeBoxes<D, K>& boxes) {
  std::copy_n(block.first, block.count, boxes.first);
  for (int k = 0; k < block.count; k += 4)
    boxes.set_four(k, [&](const std::array<int, 3>& i) {
      Pack product(load4(&block.N[0][i[0]][k]));
      for (std::size_t d = 1; d < D; ++d) product *= Pack(load4(&block.N[d][i[d]][k]));
      return product;
    });
  return true;
}

namespace detail {

/// Finds the first node along axis d that a corner reaches, for each of four particles. Returns false if the corners of
/// some reach too far for a box.
template <int D, int K>
[[gnu::always_inline]] inline bool find_lowest(const CpdiBlock<D, K>& block, std::size_t d, int k, Int4& lowest) {
  Int4 highest = lowest = load4(&block.node[0][d][k]);
  for (int c = 1; c < block.corners; ++c) {
    const Int4 node = load4(&block.node[c][d][k]);
    lowest = node < lowest ? node : lowest;
    highest = node > highest ? node : highest;
  }
  return all(__builtin_convertvector(highest - lowest < 2, Mask4));
}

/// Weights per axis of the nodes in the boxes of four particles, for each corner: zero on nodes that the corner does
/// not reach.
template <int D, int K>
using CornerWeights = std::array<std::array<std::array<Pack, K + 1>, D>, 1 << D>;

template <int D, int K>
[[gnu::always_inline]] inline void spread(const CpdiBlock<D, K>& block, std::size_t d, int k, const Int4& lowest,
                                          CornerWeights<D, K>& S) {
  for (std::size_t c = 0; c < S.size(); ++c) {
    const Mask4 is_lowest = __builtin_convertvector(load4(&block.node[c][d][k]) == lowest, Mask4);
    for (std::size_t i = 0; i <= K; ++i) {
      const Double4 near = i < K ? load4(&block.S[c][d][i][k]) : Double4{};
      const Double4 far = i > 0 ? load4(&block.S[c][d][i - 1][k]) : Double4{};
      S[c][d][i] = Pack(is_lowest ? near : far);
    }
  }
}

}  // namespace detail

/// Puts the nodes of all corners of a particle together in its box. Returns false, and boxes that cannot be used, if
/// the nodes of some particle do not fit.
template <int D, int K>
bool find_boxes(const CpdiBlock<D, K>& block, const Grid<D>& grid, NodeBoxes<D, K + 1>& boxes) {
  for (int k = 0; k < block.count; k += 4) {
    Int4 first = Int4{} + grid.node({});
    detail::CornerWeights<D, K> S;
    for (std::size_t d = 0; d < D; ++d) {
      Int4 lowest;
      if (!detail::find_lowest(block, d, k, lowest)) return false;
      detail::spread<D, K>(block, d, k, lowest, S);
      first += grid.stride(static_cast<int>(d)) * lowest;
    }
    store4(first, &boxes.first[k]);
    boxes.set_four(k, [&](const std::array<int, 3>& i) {
      Pack sum(0);
      for (const auto& corner : S) {
        Pack product = corner[0][i[0]];
        for (std::size_t d = 1; d < D; ++d) product *= corner[d][i[d]];
        sum += product;
      }
      return 1. / block.corners * sum;
    });
  }
  return true;
}

}  // namespace mpmvv::solver
