#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "solver/quad.hpp"
#include "solver/sweep.hpp"

namespace mpmvv::solver {

/// W times four particles that reach the same nodes, on a line or in the plane: each node is added to once for all of
/// them. In space a node's components fill a register by themselves, and nothing is won.
template <int D, int K, int W>
class Quartets {
  static_assert(D < 3);

 public:
  using Values = std::array<Quads<D>, W>;

  [[gnu::always_inline]] Quartets(const PointBlock<D, K, Evaluates::weights>& block, const Grid<D>& grid, int place)
      : weights_(&block.N[0][0][place]), first_(static_cast<std::size_t>(block.first[place])) {
    for (int d = 0; d < D; ++d) stride_[static_cast<std::size_t>(d)] = D * grid.stride(d);
  }

  /// Σ_i N_ip φ_i, of the w-th four
  [[gnu::always_inline]] Quads<D> gather(const std::vector<Packed<D>>& field, int w) const {
    const double* const nodes = field[first_].data();
    if constexpr (D == 1)
      return {{line(nodes, w)}};
    else
      return {{plane(nodes, w), plane(nodes + 1, w)}};
  }

  /// φ_i += Σ_p N_ip value_p
  [[gnu::always_inline]] void scatter(const Values& values, std::vector<Packed<D>>& field) const {
    double* const nodes = field[first_].data();
    if constexpr (D == 1)
      return add_line(values, nodes);
    else
      for (int j = 0; j < K; ++j) add_line(weighted(1, j, values), nodes + j * stride_[1]);
  }

 private:
  [[gnu::always_inline]] Quad N(int axis, int i, int w) const {
    return load_quad(weights_ + (axis * K + i) * block_size<D> + 4 * w);
  }
  [[gnu::always_inline]] Values weighted(int axis, int i, const Values& values) const {
    Values result;
    for (int w = 0; w < W; ++w)
      result[static_cast<std::size_t>(w)] = N(axis, i, w) * values[static_cast<std::size_t>(w)];
    return result;
  }

  /// Sums of one component.
  [[gnu::always_inline]] Quad line(const double* nodes, int w) const {
    Quad sum = N(0, 0, w) * nodes[0];
    for (int i = 1; i < K; ++i) sum += N(0, i, w) * nodes[i * D];
    return sum;
  }
  [[gnu::always_inline]] Quad plane(const double* nodes, int w) const {
    Quad sum = N(1, 0, w) * line(nodes, w);
    for (int j = 1; j < K; ++j) sum += N(1, j, w) * line(nodes + j * stride_[1], w);
    return sum;
  }

  [[gnu::always_inline]] void add_line(const Values& values, double* nodes) const {
    nodes = start_of_line(nodes);
    for (int i = 0; i < K; ++i) {
      const Values parts = weighted(0, i, values);
      Quads<D> sum = parts[0];
      for (std::size_t w = 1; w < W; ++w) sum += parts[w];
      sum.add_sums(nodes + i * D);
    }
  }

  const double* weights_;
  std::size_t first_;                     ///< storage index of the first node
  std::array<std::ptrdiff_t, D> stride_;  ///< in numbers
};

/// The particles of a block in the order of their first nodes; those of one keep theirs. The block's nodes and weights
/// follow. By insertion: they are nearly in order, and nothing may be allocated.
template <int D, int K>
void sort_by_nodes(PointBlock<D, K, Evaluates::weights>& block, std::size_t* particle) {
  const int count = block.count;
  int* const first = block.first;
  std::iota(particle, particle + count, block.begin);
  int drops = 0;
  for (int k = 1; k < count; ++k) drops += first[k] < first[k - 1] ? 1 : 0;
  if (drops == 0) return;
  for (int k = 1; k < count; ++k) {
    const int node = first[k];
    const std::size_t p = particle[k];
    int place = k;
    for (; place > 0 && first[place - 1] > node; --place) {
      first[place] = first[place - 1];
      particle[place] = particle[place - 1];
    }
    first[place] = node, particle[place] = p;
  }
  for (auto& axis : block.N)
    for (auto& weights : axis) {
      double unsorted[block_size<D>];
      std::copy_n(weights, count, unsorted);
      for (int k = 0; k < count; ++k) weights[k] = unsorted[particle[k] - block.begin];
    }
}

/// As a `NodeLoop` of one operation that uses no gradients and knows what to do with four particles at once, too. Those
/// that find no three others with their nodes go alone, as all do in space and with domains.
template <class Op>
struct QuartetLoop {
  Op op;

  template <int D>
  void operator()(const auto& block, const Grid<D>& grid) const {
    node_loop(op)(block, grid);
  }

  template <int D, int K>
  requires(D < 3) void operator()(PointBlock<D, K, Evaluates::weights>& block, const Grid<D>& grid) const {
    std::size_t particle[block_size<D>];
    sort_by_nodes(block, particle);
    const auto are_companions = [&](int k, int last) {
      return last < block.count && block.first[last] == block.first[k];
    };
    for (int k = 0; k < block.count;) {
      if (are_companions(k, k + 7)) {
        op(particle + k, Quartets<D, K, 2>(block, grid, k));
        k += 8;
      } else if (are_companions(k, k + 3)) {
        op(particle + k, Quartets<D, K, 1>(block, grid, k));
        k += 4;
      } else {
        op(particle[k], block.stencil(k, grid), block, k);
        ++k;
      }
    }
  }
};

template <class Op>
QuartetLoop(const Op&) -> QuartetLoop<Op>;

}  // namespace mpmvv::solver
