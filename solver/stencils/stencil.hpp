#pragma once
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "solver/simd/padded.hpp"
#include "solver/simd/pair_line.hpp"

namespace mpmvv::solver {

/// A value on a particle and its derivatives: column J is the one along x_J.
template <int D>
struct ValueAndGradient {
  Padded<D> value;
  PaddedMat<D> gradient;
};

/// An address that counts as known only here. Left to itself g++ keeps one index of a node for all fields and makes
/// each address of it anew, three instructions more; those of a line's nodes lie at fixed distances from the first.
template <class V>
[[gnu::always_inline]] inline V* start_of_line(V* nodes) {
  asm("" : "+r"(nodes));
  return nodes;
}

/// The nodes of one point: K along each axis, with weights per axis, copied out of their block so that the compiler
/// knows that no addition to a node changes them. Weights of nodes are tensor products, S (18), and sums with them are
/// formed axis by axis: what the nodes of a line or a plane share is multiplied once. Inlined by decree: called as
/// functions, the additions take half as long again, and g++ decides now one way, now the other.
template <int D, int K>
struct Weights {
  std::size_t first;  ///< storage index of the first node
  std::array<std::ptrdiff_t, D> stride;
  double N[D][K];

  /// Σ_i N_i φ_i
  template <class V>
  [[gnu::always_inline]] V gather(const std::vector<V>& field) const {
    return value(field.data() + first);
  }

  /// φ_i += N_i value
  template <class V>
  [[gnu::always_inline]] void scatter(const V& value, std::vector<V>& field) const {
    add(value, field.data() + first);
  }

 private:
  /// Σ_i N_i φ_i over the axes up to `axis`
  template <int axis = D - 1, class V>
  [[gnu::always_inline]] V value(const V* nodes) const {
    if constexpr (axis < 0) {
      return *nodes;
    } else if constexpr (axis == 1 && std::is_same_v<V, Padded<2>>) {
      PairLine<K> sum(N[1][0], nodes);
      for (int j = 1; j < K; ++j) sum += PairLine<K>(N[1][j], nodes + j * stride[1]);
      return sum.weighted(N[0]);
    } else {
      V sum = N[axis][0] * value<axis - 1>(nodes);
      for (int i = 1; i < K; ++i) sum += N[axis][i] * value<axis - 1>(nodes + i * stride[axis]);
      return sum;
    }
  }

  /// φ_i += N_i value
  template <int axis = D - 1, class V>
  [[gnu::always_inline]] void add(const V& value, V* nodes) const {
    if constexpr (axis == 0) {
      nodes = start_of_line(nodes);
      for (int i = 0; i < K; ++i) nodes[i] += N[0][i] * value;
    } else {
      for (int i = 0; i < K; ++i) add<axis - 1>(V(N[axis][i] * value), nodes + i * stride[axis]);
    }
  }
};

/// The nodes of a particle that is a point: their weights with the gradients, per axis as well.
template <int D, int K>
struct Stencil : Weights<D, K> {
  using Weights<D, K>::first, Weights<D, K>::stride, Weights<D, K>::N, Weights<D, K>::scatter;
  double dN[D][K];

  /// Σ_i N_ip φ_i and Σ_i φ_i ⊗ ∇N_ip
  [[gnu::always_inline]] ValueAndGradient<D> gather_with_gradient(const std::vector<Padded<D>>& field) const {
    return value_and_gradient(field.data() + first);
  }

  /// φ_i += N_ip value + gradient ∇N_ip
  [[gnu::always_inline]] void scatter(const ValueAndGradient<D>& source, std::vector<Padded<D>>& field) const {
    add(source, field.data() + first);
  }

 private:
  /// Both sums. Written out for each dimension: the sums have to stay in registers.
  [[gnu::always_inline]] ValueAndGradient<D> value_and_gradient(const Padded<D>* nodes) const {
    Padded<D> value = Padded<D>::Zero(), d0 = value, d1 = value, d2 = value;
    if constexpr (D == 1) {
      add_line(nodes, value, d0);
      return {value, d0};
    } else if constexpr (D == 2) {
      PairLine<K> sum(N[1][0], nodes), slope(dN[1][0], nodes);
      for (int j = 1; j < K; ++j) {
        sum += PairLine<K>(N[1][j], nodes + j * stride[1]);
        slope += PairLine<K>(dN[1][j], nodes + j * stride[1]);
      }
      ValueAndGradient<D> result{sum.weighted(N[0]), {}};
      result.gradient.col(0) = sum.weighted(dN[0]), result.gradient.col(1) = slope.weighted(N[0]);
      return result;
    } else {
      for (int l = 0; l < K; ++l) {
        Padded<D> plane = Padded<D>::Zero(), plane_d0 = plane, plane_d1 = plane;
        for (int j = 0; j < K; ++j) add_plane_row(nodes + j * stride[1] + l * stride[2], j, plane, plane_d0, plane_d1);
        value += N[2][l] * plane;
        d0 += N[2][l] * plane_d0;
        d1 += N[2][l] * plane_d1;
        d2 += dN[2][l] * plane;
      }
      ValueAndGradient<D> sum{value, {}};
      sum.gradient.col(0) = d0, sum.gradient.col(1) = d1, sum.gradient.col(2) = d2;
      return sum;
    }
  }

  /// φ_i += N_ip value + gradient ∇N_ip
  template <int axis = D - 1>
  [[gnu::always_inline]] void add(const ValueAndGradient<D>& source, Padded<D>* nodes) const {
    if constexpr (axis == 0) {
      nodes = start_of_line(nodes);
      for (int i = 0; i < K; ++i) {
        nodes[i] += N[0][i] * source.value;
        nodes[i] += dN[0][i] * source.gradient.col(0);
      }
    } else if constexpr (D == 2) {
      PairLine<K> line(N[0], source.value);
      line += PairLine<K>(dN[0], source.gradient.col(0));
      const PairLine<K> slope(N[0], source.gradient.col(1));
      for (int j = 0; j < K; ++j) line.add_to(nodes + j * stride[1], N[1][j], dN[1][j], slope);
    } else {
      for (int i = 0; i < K; ++i) {
        ValueAndGradient<D> part;
        part.value = N[axis][i] * source.value + dN[axis][i] * source.gradient.col(axis);
        for (int d = 0; d < axis; ++d) part.gradient.col(d) = N[axis][i] * source.gradient.col(d);
        add<axis - 1>(part, nodes + i * stride[axis]);
      }
    }
  }

  [[gnu::always_inline]] void add_line(const Padded<D>* nodes, Padded<D>& value, Padded<D>& d0) const {
    for (int i = 0; i < K; ++i) {
      value += N[0][i] * nodes[i];
      d0 += dN[0][i] * nodes[i];
    }
  }
  [[gnu::always_inline]] void add_plane_row(const Padded<D>* nodes, int j, Padded<D>& value, Padded<D>& d0,
                                            Padded<D>& d1) const {
    Padded<D> sum = Padded<D>::Zero(), sum_d0 = sum;
    add_line(nodes, sum, sum_d0);
    value += N[1][j] * sum;
    d0 += N[1][j] * sum_d0;
    d1 += dN[1][j] * sum;
  }
};

}  // namespace mpmvv::solver
