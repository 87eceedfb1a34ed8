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
    V sum = V::Zero();
    for (int line = 0; line < lines; ++line) {
      const V* const nodes = &field[first] + offset(line);
      for (int i = 0; i < W; ++i) sum += N[line * W + i] * nodes[i];
    }
    return sum;
  }

  /// φ_i += N_ip value
  template <class V>
  [[gnu::always_inline]] void scatter(const V& value, std::vector<V>& field) const {
    for (int line = 0; line < lines; ++line) {
      V* const nodes = start_of_line(&field[first] + offset(line));
      for (int i = 0; i < W; ++i) nodes[i] += N[line * W + i] * value;
    }
  }

 private:
  static constexpr int lines = power(W, D - 1);

  /// Of a line's first node.
  [[gnu::always_inline]] std::ptrdiff_t offset(int line) const {
    if constexpr (D == 1) return 0;
    if constexpr (D == 2) return line * stride[1];
    if constexpr (D == 3) return line % W * stride[1] + line / W * stride[2];
  }
};

}  // namespace mpmvv::solver
