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

/// A value interpolated from the grid, and its gradient: column J is the derivative along x_J.
template <int D>
struct ValueAndGradient {
  Packed<D> value;
  PackedMat<D> gradient;
};

/// The nodes of one particle, K along each axis, with weights and gradients per axis. Copied out of the block, so that
/// the compiler knows that no addition to a node changes them.
template <int D, int K>
struct Stencil {
  double N[D][K], dN[D][K];
  std::array<std::ptrdiff_t, D> stride;

  Stencil(const auto& block, int k, const Grid<D>& grid) {
    for (int d = 0; d < D; ++d) {
      stride[static_cast<std::size_t>(d)] = grid.stride(d);
      for (int i = 0; i < K; ++i) N[d][i] = block.N[d][i][k], dN[d][i] = block.dN[d][i][k];
    }
  }

  /// Calls visit(offset, N, ∇N) for each row of nodes along the first axis: its first node's place behind the first of
  /// all, and what the row's nodes share: the product of the weights of the other axes, and its derivatives.
  template <class Visit>
  void for_rows(const Visit& visit) const {
    if constexpr (D == 1) {
      visit(0, 1.0, std::array<double, 1>{});
    } else if constexpr (D == 2) {
      for (int j = 0; j < K; ++j) visit(j * stride[1], N[1][j], std::array<double, 2>{0, dN[1][j]});
    } else {
      for (int l = 0; l < K; ++l)
        for (int j = 0; j < K; ++j)
          visit(j * stride[1] + l * stride[2], N[1][j] * N[2][l],
                std::array<double, 3>{0, dN[1][j] * N[2][l], N[1][j] * dN[2][l]});
    }
  }
};

/// A few neighbouring particles, the nodes that each of them reaches, and what the stages of a sweep hand to each
/// other. Weights and gradients are kept per axis; their tensor products, S (18), are formed row by row of nodes.
template <int D, int K>
struct Block {
  int slab;
  std::size_t begin;
  int count;
  int first[block_size<D>];        ///< storage index of the first node
  double N[D][K][block_size<D>];   ///< weights
  double dN[D][K][block_size<D>];  ///< gradients, per length
  PackedMat<D> tau[block_size<D>];  ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size<D>];         ///< body acceleration, by EvaluateBodyForce

  /// Calls visit(k, p) for each particle p = begin + k. Neighbours add to the same nodes, one having to wait for the
  /// other; the block is therefore visited in four interleaved parts.
  template <class Visit>
  void for_particles(const Visit& visit) const {
    const int stride = (count + 3) / 4;
    for (int start = 0; start < stride; ++start)
      for (int k = start; k < count; k += stride) visit(k, begin + static_cast<std::size_t>(k));
  }

  /// Σ_i N_ip φ_i
  template <class V>
  V gather(int k, const Grid<D>& grid, const std::vector<V>& field) const {
    const Stencil<D, K> s(*this, k, grid);
    const V* const from = field.data() + first[k];
    V value = V::Zero();
    s.for_rows([&](std::ptrdiff_t row, double N_row, const auto&) {
      V sum = s.N[0][0] * from[row];
      for (int i = 1; i < K; ++i) sum += s.N[0][i] * from[row + i];
      value += N_row * sum;
    });
    return value;
  }

  /// Σ_i N_ip φ_i and Σ_i φ_i ⊗ ∇N_ip
  ValueAndGradient<D> gather_with_gradient(int k, const Grid<D>& grid, const std::vector<Packed<D>>& field) const {
    const Stencil<D, K> s(*this, k, grid);
    const Packed<D>* const from = field.data() + first[k];
    ValueAndGradient<D> result{Packed<D>::Zero(), PackedMat<D>::Zero()};
    s.for_rows([&](std::ptrdiff_t row, double N_row, const std::array<double, D>& dN_row) {
      Packed<D> sum = s.N[0][0] * from[row], slope = s.dN[0][0] * from[row];
      for (int i = 1; i < K; ++i) {
        sum += s.N[0][i] * from[row + i];
        slope += s.dN[0][i] * from[row + i];
      }
      result.value += N_row * sum;
      result.gradient.col(0) += N_row * slope;
      for (int d = 1; d < D; ++d) result.gradient.col(d) += dN_row[static_cast<std::size_t>(d)] * sum;
    });
    return result;
  }

  /// φ_i += N_ip value
  template <class V>
  void scatter(int k, const Grid<D>& grid, const V& value, std::vector<V>& field) const {
    const Stencil<D, K> s(*this, k, grid);
    V* const to = field.data() + first[k];
    s.for_rows([&](std::ptrdiff_t row, double N_row, const auto&) {
      const V share = N_row * value;
      for (int i = 0; i < K; ++i) to[row + i] += s.N[0][i] * share;
    });
  }

  /// φ_i += gradient ∇N_ip
  void scatter_gradient(int k, const Grid<D>& grid, const PackedMat<D>& gradient,
                        std::vector<Packed<D>>& field) const {
    scatter_to(k, grid, gradient, field, [](double) { return Packed<D>(Packed<D>::Zero()); });
  }

  /// φ_i += N_ip value + gradient ∇N_ip
  void scatter(int k, const Grid<D>& grid, const ValueAndGradient<D>& source, std::vector<Packed<D>>& field) const {
    scatter_to(k, grid, source.gradient, field, [&](double N_row) { return Packed<D>(N_row * source.value); });
  }

 private:
  template <class Share>
  void scatter_to(int k, const Grid<D>& grid, const PackedMat<D>& gradient, std::vector<Packed<D>>& field,
                  const Share& share_of) const {
    const Stencil<D, K> s(*this, k, grid);
    Packed<D>* const to = field.data() + first[k];
    s.for_rows([&](std::ptrdiff_t row, double N_row, const std::array<double, D>& dN_row) {
      Packed<D> share = share_of(N_row);
      for (int d = 1; d < D; ++d) share += dN_row[static_cast<std::size_t>(d)] * gradient.col(d);
      const Packed<D> slope = N_row * gradient.col(0);
      for (int i = 0; i < K; ++i) to[row + i] += s.N[0][i] * share + s.dN[0][i] * slope;
    });
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
