#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/basis/basis.hpp"
#include "solver/grid.hpp"
#include "solver/particles.hpp"

namespace mpmvv::solver {

/// Why a run has blown up. Bits, since several particles can fail in one sweep.
enum class Fault : unsigned { none = 0, outside = 1, outgrown = 2, inverted = 4 };

constexpr Fault operator|(Fault a, Fault b) {
  return static_cast<Fault>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool contains(Fault faults, Fault one) {
  return (static_cast<unsigned>(faults) & static_cast<unsigned>(one)) != 0;
}

template <int D>
inline constexpr int block_size = 256 >> D;

/// A value on a particle and its derivatives: column J is the one along x_J.
template <int D>
struct ValueAndGradient {
  Packed<D> value;
  PackedMat<D> gradient;
};

/// The nodes of one particle: K along each axis, with weights and gradients per axis, copied out of the block so that
/// the compiler knows that no addition to a node changes them. Weights of nodes are tensor products, S (18), and sums
/// with them are formed axis by axis: what the nodes of a line or a plane share is multiplied once.
template <int D, int K>
struct Stencil {
  std::size_t first;  ///< storage index of the first node
  std::array<std::ptrdiff_t, D> stride;
  double N[D][K], dN[D][K];

  /// Σ_i N_ip φ_i
  template <class V>
  V gather(const std::vector<V>& field) const {
    return value(field.data() + first);
  }

  /// Σ_i N_ip φ_i and Σ_i φ_i ⊗ ∇N_ip
  ValueAndGradient<D> gather_with_gradient(const std::vector<Packed<D>>& field) const {
    return value_and_gradient(field.data() + first);
  }

  /// φ_i += N_ip source, or φ_i += N_ip value + gradient ∇N_ip
  template <class Source, class V>
  void scatter(const Source& source, std::vector<V>& field) const {
    add(source, field.data() + first);
  }

 private:
  /// Σ_i N_ip φ_i over the axes up to `axis`
  template <int axis = D - 1, class V>
  V value(const V* nodes) const {
    if constexpr (axis < 0) {
      return *nodes;
    } else {
      V sum = N[axis][0] * value<axis - 1>(nodes);
      for (int i = 1; i < K; ++i) sum += N[axis][i] * value<axis - 1>(nodes + i * stride[axis]);
      return sum;
    }
  }

  /// Σ_i N_ip φ_i and Σ_i φ_i ⊗ ∇N_ip. Written out for each dimension: the sums have to stay in registers.
  ValueAndGradient<D> value_and_gradient(const Packed<D>* nodes) const {
    Packed<D> value = Packed<D>::Zero(), d0 = value, d1 = value, d2 = value;
    if constexpr (D == 1) {
      add_line(nodes, value, d0);
      return {value, d0};
    } else if constexpr (D == 2) {
      for (int j = 0; j < K; ++j) add_plane_row(nodes + j * stride[1], j, value, d0, d1);
      ValueAndGradient<D> sum{value, {}};
      sum.gradient.col(0) = d0, sum.gradient.col(1) = d1;
      return sum;
    } else {
      for (int l = 0; l < K; ++l) {
        Packed<D> plane = Packed<D>::Zero(), plane_d0 = plane, plane_d1 = plane;
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

  /// φ_i += N_ip value
  template <int axis = D - 1, class V>
  void add(const V& value, V* nodes) const {
    if constexpr (axis < 0) {
      *nodes += value;
    } else if constexpr (axis == 0) {
      for (int i = 0; i < K; ++i) nodes[i] += N[0][i] * value;
    } else {
      for (int i = 0; i < K; ++i) add<axis - 1>(V(N[axis][i] * value), nodes + i * stride[axis]);
    }
  }

  /// φ_i += N_ip value + gradient ∇N_ip
  template <int axis = D - 1>
  void add(const ValueAndGradient<D>& source, Packed<D>* nodes) const {
    for (int i = 0; i < K; ++i) {
      if constexpr (axis == 0) {
        nodes[i] += N[0][i] * source.value;
        nodes[i] += dN[0][i] * source.gradient.col(0);
      } else {
        ValueAndGradient<D> part;
        part.value = N[axis][i] * source.value + dN[axis][i] * source.gradient.col(axis);
        for (int d = 0; d < axis; ++d) part.gradient.col(d) = N[axis][i] * source.gradient.col(d);
        add<axis - 1>(part, nodes + i * stride[axis]);
      }
    }
  }

  void add_line(const Packed<D>* nodes, Packed<D>& value, Packed<D>& d0) const {
    for (int i = 0; i < K; ++i) {
      value += N[0][i] * nodes[i];
      d0 += dN[0][i] * nodes[i];
    }
  }
  void add_plane_row(const Packed<D>* nodes, int j, Packed<D>& value, Packed<D>& d0, Packed<D>& d1) const {
    Packed<D> line = Packed<D>::Zero(), line_d0 = line;
    add_line(nodes, line, line_d0);
    value += N[1][j] * line;
    d0 += N[1][j] * line_d0;
    d1 += dN[1][j] * line;
  }
};

/// A few neighbouring particles, the nodes that each of them reaches, and what the stages of a sweep hand to each
/// other. Weights and gradients are kept per axis; their tensor products, S (18), are formed row by row of nodes.
template <int D, int K>
struct Block {
  int slab;
  std::size_t begin;
  int count;
  int first[block_size<D>];         ///< storage index of the first node
  double N[D][K][block_size<D>];    ///< weights
  double dN[D][K][block_size<D>];   ///< gradients, per length
  PackedMat<D> tau[block_size<D>];  ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size<D>];          ///< body acceleration, by EvaluateBodyForce

  Stencil<D, K> stencil(int k, const Grid<D>& grid) const {
    Stencil<D, K> s;
    s.first = static_cast<std::size_t>(first[k]);
    for (int d = 0; d < D; ++d) {
      s.stride[static_cast<std::size_t>(d)] = grid.stride(d);
      for (int i = 0; i < K; ++i) s.N[d][i] = N[d][i][k], s.dN[d][i] = dN[d][i][k];
    }
    return s;
  }
};

/// `value` moved into [least, most], a NaN to `least`; counts in `strays` those that had to be moved.
inline double confined(double value, double least, double most, int& strays) {
  const double inside = std::min(std::max(least, value), most);
  strays += inside == value ? 0 : 1;
  return inside;
}

/// Evaluates the stencils of a block at its particles' positions. A particle out of reach of the grid, or a NaN, is
/// a fault; its stencil then lies somewhere inside storage, and the caller stops the run.
template <int D, class B>
Fault evaluate_stencils(const B& basis, const Particles<D>& particles, const Grid<D>& grid,
                        Block<D, B::support>& block) {
  const double inverse_h = 1 / grid.h();
  const int count = block.count;
  int outside = 0, outgrown = 0;
  std::fill_n(block.first, count, grid.node({}));
  for (int d = 0; d < D; ++d) {
    const double lower = grid.lower()[d];
    const int cells = grid.cells()[d], stride = grid.stride(d);
    const double least = B::ghost == 0 ? 0 : 1 - B::ghost;
    const double most = B::ghost == 0 ? cells : std::nextafter(cells - least, 0.0);
    const Vec<D>* x = &particles.x[block.begin];
    double width[block_size<D>] = {};
    if constexpr (B::width != ParticleWidth::none) {
      const Vec<D>* l = &particles.l[block.begin];
      for (int k = 0; k < count; ++k) width[k] = confined(l[k][d], std::numeric_limits<double>::min(), 1, outgrown);
    }
    for (int k = 0; k < count; ++k) {
      const double xi = confined((x[k][d] - lower) * inverse_h, least, most, outside);
      double N[B::support], dN[B::support];
      block.first[k] += stride * basis.evaluate({xi, cells, width[k]}, N, dN);
      for (int i = 0; i < B::support; ++i) {
        block.N[d][i][k] = N[i];
        block.dN[d][i][k] = dN[i] * inverse_h;
      }
    }
  }
  return (outside > 0 ? Fault::outside : Fault::none) | (outgrown > 0 ? Fault::outgrown : Fault::none);
}

}  // namespace mpmvv::solver
