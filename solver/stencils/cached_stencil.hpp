#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "solver/stencils/stencil.hpp"

namespace mpmvv::solver {

/// A box of nodes, W along each axis, with a weight N_ip on each that is no product of weights per axis.
template <int D, int W>
struct CachedStencil {
  std::size_t first;  ///< storage index of the first node
  std::array<std::ptrdiff_t, D> stride;
  const double* N;  ///< W^D, the first axis fastest

  /// Σ_i N_ip φ_i
  template <class V>
  [[gnu::always_inline]] V gather(const std::vector<V>& field) const {
    return value<D - 1>(N, field.data() + first);
  }

  /// φ_i += N_ip value
  template <class V>
  [[gnu::always_inline]] void scatter(const V& value, std::vector<V>& field) const {
    add<D - 1>(N, value, field.data() + first);
  }

 private:
  template <int axis, class V>
  [[gnu::always_inline]] V value(const double* weights, const V* nodes) const {
    if constexpr (axis == 0) {
      V sum = weights[0] * nodes[0];
      for (int i = 1; i < W; ++i) sum += weights[i] * nodes[i];
      return sum;
    } else {
      V sum = value<axis - 1>(weights, nodes);
      for (int i = 1; i < W; ++i) sum += value<axis - 1>(weights + i * power(W, axis), nodes + i * stride[axis]);
      return sum;
    }
  }

  template <int axis, class V>
  [[gnu::always_inline]] void add(const double* weights, const V& value, V* nodes) const {
    nodes = start_of_line(nodes);
    for (int i = 0; i < W; ++i)
      if constexpr (axis == 0)
        nodes[i] += weights[i] * value;
      else
        add<axis - 1>(weights + i * power(W, axis), value, nodes + i * stride[axis]);
  }
};

}  // namespace mpmvv::solver
