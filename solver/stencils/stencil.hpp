#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "solver/array.hpp"
#include "solver/simd/doubles.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

/// A value on a particle, or a pack of the values on four particles, and its gradient, whose column J is the derivative
/// along x_J.
template <int D, class Number = double>
struct ValueAndGradient {
  Eigen::Matrix<Number, padded_size<D>, 1> value;
  Eigen::Matrix<Number, padded_size<D>, D> gradient;
};
template <class Value, class Gradient>
ValueAndGradient(const Value&, const Gradient&)
    -> ValueAndGradient<Gradient::ColsAtCompileTime, typename Gradient::Scalar>;

/// Returns the address of the first node of a line, which the empty asm hides from the optimiser. Left to itself g++
/// keeps one index of a node for all fields and computes each address from it anew, which takes three instructions
/// more. The other nodes of the line lie at fixed distances from the address returned here.
template <class V>
[[gnu::always_inline]] inline V* start_of_line(V* nodes) {
  asm("" : "+r"(nodes));
  return nodes;
}

/// The number of doubles in the value of a field.
template <class V>
inline constexpr int components = sizeof(V) / sizeof(double);

/// Returns N_i for every component of each node i of a line: K nodes of C components.
template <int K, int C>
[[gnu::always_inline]] inline Doubles<K * C> along_line(const double* N) {
  return Doubles<K * C>::each([N](int k) __attribute__((always_inline)) { return N[k / C]; });
}
/// Returns the same value on each of K nodes.
template <int K, class V>
[[gnu::always_inline]] inline Doubles<K * components<V>> on_each_node(const V& value) {
  return Doubles<K * components<V>>::each([&](int k)
                                              __attribute__((always_inline)) { return value[k % components<V>]; });
}
/// Returns Σ_i N_i φ_i over the nodes of a line.
template <class V, int n>
[[gnu::always_inline]] inline V sum_of_nodes(const Doubles<n>& N, const Doubles<n>& line) {
  const auto sum = sum_of_products<components<V>>(N, line);
  return V::Map(reinterpret_cast<const double*>(&sum));
}

/// The nodes of one point, K along each axis, with weights per axis. The weights are copied out of their block so that
/// the compiler knows that no addition to a node changes them; if they are read where they lie, a step in space takes
/// 1.09 times as long. Weights of nodes are tensor products, S (18), and sums with them are formed axis by axis: what
/// the nodes of a line or a plane share is multiplied once. The functions are always_inline: when they are called as
/// functions, the additions take half as long again, and whether g++ inlines them of its own accord varies.
template <int D, int K>
struct Weights {
  std::size_t first;  ///< storage index of the first node
  std::array<std::ptrdiff_t, D> stride;
  double N[D][K];

  /// Returns Σ_i N_i φ_i.
  template <class V>
  [[gnu::always_inline]] V gather(const Array<V>& field) const {
    const V* const nodes = field.data() + first;
    if constexpr (D == 1) {
      V sum = N[0][0] * nodes[0];
      for (int i = 1; i < K; ++i) sum += N[0][i] * nodes[i];
      return sum;
    } else {
      return sum_of_nodes<V>(along_line<K, components<V>>(N[0]), line<D - 1>(nodes));
    }
  }

  /// φ_i += N_i value
  template <class V>
  [[gnu::always_inline]] void scatter(const V& value, Array<V>& field) const {
    V* const nodes = start_of_line(field.data() + first);
    if constexpr (D == 1)
      for (int i = 0; i < K; ++i) nodes[i] += N[0][i] * value;
    else
      add_line<D - 1>(each_node_of_line(on_each_node<1>(value), std::make_index_sequence<K>{}), nodes);
  }

 private:
  /// Returns Σ_i N_i φ_i over the axes from the second up to `axis`, for each node of a line along the first axis.
  template <int axis, class V>
  [[gnu::always_inline]] Doubles<K * components<V>> line(const V* nodes) const {
    if constexpr (axis == 0) {
      return Doubles<K * components<V>>::load(reinterpret_cast<const double*>(nodes));
    } else {
      auto sum = N[axis][0] * line<axis - 1>(nodes);
      for (int i = 1; i < K; ++i) sum += N[axis][i] * line<axis - 1>(nodes + i * stride[axis]);
      return sum;
    }
  }
  /// N_i value for the nodes of a line along the first axis.
  template <int C>
  using Line = std::array<Doubles<C>, K>;
  template <int C, std::size_t... i>
  [[gnu::always_inline]] Line<C> each_node_of_line(const Doubles<C>& value, std::index_sequence<i...>) const {
    return {N[0][i] * value...};
  }
  /// Adds `value`, multiplied by the weights along the axes from `axis` down to the second, to one node after the
  /// other. Two nodes at once would take longer: the corners of a particle's domain often lie a node apart, and a read
  /// of two nodes, one of which has just been written, has to wait until that is in the cache.
  template <int axis, class V>
  [[gnu::always_inline]] void add_line(const Line<components<V>>& value, V* nodes) const {
    for (int i = 0; i < K; ++i) {
      V* const next = start_of_line(nodes + i * stride[axis]);
      Line<components<V>> part = value;
      for (auto& of_node : part) of_node = N[axis][i] * of_node;
      if constexpr (axis > 1)
        add_line<axis - 1>(part, next);
      else
        for (std::size_t j = 0; j < K; ++j) {
          auto sum = Doubles<components<V>>::load(next[j].data());
          sum += part[j];
          sum.store(next[j].data());
        }
    }
  }
};

/// The nodes of a particle that is a point, with their weights and the gradients of these, both per axis.
template <int D, int K>
struct Stencil : Weights<D, K> {
  using Weights<D, K>::first, Weights<D, K>::stride, Weights<D, K>::N, Weights<D, K>::scatter;
  double dN[D][K];

  /// Returns Σ_i N_ip φ_i and Σ_i φ_i ⊗ ∇N_ip.
  [[gnu::always_inline]] ValueAndGradient<D> gather_with_gradient(const Array<Padded<D>>& field) const {
    const Padded<D>* const nodes = field.data() + first;
    ValueAndGradient<D> sum;
    if constexpr (D == 1) {
      sum.value.setZero(), sum.gradient.setZero();
      for (int i = 0; i < K; ++i) {
        sum.value += N[0][i] * nodes[i];
        sum.gradient += dN[0][i] * nodes[i];
      }
    } else {
      sum = gather_part<0>(nodes);
    }
    return sum;
  }

  /// φ_i += N_ip value + gradient ∇N_ip
  [[gnu::always_inline]] void scatter(const ValueAndGradient<D>& source, Array<Padded<D>>& field) const {
    Padded<D>* const nodes = field.data() + first;
    if constexpr (D == 1) {
      Padded<D>* const line = start_of_line(nodes);
      for (int i = 0; i < K; ++i) line[i] += N[0][i] * source.value + dN[0][i] * source.gradient;
    } else {
      scatter_part<0>(source, nodes);
    }
  }

 private:
  static constexpr int C = components<Padded<D>>;
  /// How many nodes of a line are handled at once. In space each node has five vectors in use at a time; those of four
  /// nodes do not fit in sixteen registers, and with 32 registers four nodes take no less time.
  static constexpr int at_once = std::min(K, D == 3 && K > 3 ? 2 : 8);
  template <int begin>
  static constexpr int nodes_from = std::min(at_once, K - begin);

  /// A value on each of n nodes along the first axis, and its gradients along the other axes.
  template <int n>
  struct LineSums {
    Doubles<n * C> value;
    std::array<Doubles<n * C>, D - 1> slope;
  };

  /// Returns the sums over the nodes of each line from the one at `begin` to the last.
  template <int begin>
  [[gnu::always_inline]] ValueAndGradient<D> gather_part(const Padded<D>* nodes) const {
    constexpr int n = nodes_from<begin>;
    const LineSums<n> lines = sum_lines<D - 1, n>(nodes + begin);
    const auto weight = along_line<n, C>(N[0] + begin), slope = along_line<n, C>(dN[0] + begin);
    ValueAndGradient<D> sum;
    sum.value = sum_of_nodes<Padded<D>>(weight, lines.value);
    sum.gradient.col(0) = sum_of_nodes<Padded<D>>(slope, lines.value);
    for (int d = 1; d < D; ++d) sum.gradient.col(d) = sum_of_nodes<Padded<D>>(weight, lines.slope[d - 1]);
    if constexpr (begin + n < K) {
      const ValueAndGradient<D> rest = gather_part<begin + n>(nodes);
      sum.value += rest.value;
      for (int d = 0; d < D; ++d) sum.gradient.col(d) += rest.gradient.col(d);
    }
    return sum;
  }
  template <int begin>
  [[gnu::always_inline]] void scatter_part(const ValueAndGradient<D>& source, Padded<D>* nodes) const {
    constexpr int n = D == 2 && K == 3 ? 1 : nodes_from<begin>;  // two would straddle what the last particle wrote
    const auto weight = along_line<n, C>(N[0] + begin), slope = along_line<n, C>(dN[0] + begin);
    LineSums<n> lines{weight * on_each_node<n>(source.value), {}};
    lines.value += slope * on_each_node<n>(Padded<D>(source.gradient.col(0)));
    for (int d = 1; d < D; ++d) lines.slope[d - 1] = weight * on_each_node<n>(Padded<D>(source.gradient.col(d)));
    add_lines<D - 1, n>(lines, nodes + begin);
    if constexpr (begin + n < K) scatter_part<begin + n>(source, nodes);
  }

  /// Returns the sums over the axes from the second up to `axis`, and of the slopes those along these axes.
  template <int axis, int n>
  [[gnu::always_inline]] LineSums<n> sum_lines(const Padded<D>* nodes) const {
    LineSums<n> sum;
    if constexpr (axis == 0) {
      sum.value = Doubles<n * C>::load(nodes->data());
    } else {
      const LineSums<n> part = sum_lines<axis - 1, n>(nodes);
      sum.value = N[axis][0] * part.value;
      for (int d = 0; d < axis - 1; ++d) sum.slope[d] = N[axis][0] * part.slope[d];
      sum.slope[axis - 1] = dN[axis][0] * part.value;
      for (int i = 1; i < K; ++i) {
        const LineSums<n> next = sum_lines<axis - 1, n>(nodes + i * stride[axis]);
        sum.value += N[axis][i] * next.value;
        for (int d = 0; d < axis - 1; ++d) sum.slope[d] += N[axis][i] * next.slope[d];
        sum.slope[axis - 1] += dN[axis][i] * next.value;
      }
    }
    return sum;
  }

  /// Adds to the nodes, along the axes from `axis` down to the second: the transpose of `sum_lines`.
  template <int axis, int n>
  [[gnu::always_inline]] void add_lines(const LineSums<n>& source, Padded<D>* nodes) const {
    for (int i = 0; i < K; ++i) {
      Padded<D>* const next = start_of_line(nodes + i * stride[axis]);
      if constexpr (axis == 1) {
        auto sum = Doubles<n * C>::load(next->data());
        sum += N[1][i] * source.value;
        sum += dN[1][i] * source.slope[0];
        sum.store(next->data());
      } else {
        LineSums<n> part{N[axis][i] * source.value, {}};
        part.value += dN[axis][i] * source.slope[axis - 1];
        for (int d = 0; d < axis - 1; ++d) part.slope[d] = N[axis][i] * source.slope[d];
        add_lines<axis - 1, n>(part, next);
      }
    }
  }
};

}  // namespace mpmvv::solver
