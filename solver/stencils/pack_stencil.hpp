#pragma once
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "solver/simd/pack.hpp"
#include "solver/stencils/point_block.hpp"

namespace mpmvv::solver {

/// What four particles add to their nodes: N_ip value + gradient ∇N_ip.
template <int D>
struct PackValuesAndGradients {
  PackVec<D> value;
  PackMat<D> gradient;
};

template <int D>
[[gnu::always_inline]] inline void set_first(const PackValuesAndGradients<D>& source, const LaneMask& kept,
                                             PackValuesAndGradients<D>& to) {
  set_first(source.value, kept, to.value);
  set_first(source.gradient, kept, to.gradient);
}

template <class Work>
[[gnu::noinline, gnu::flatten]] auto apart(const Work& work) {
  return work();
}

/// What `work` returns. In space its loops are functions of their own: inlined they save a hundredth of the time to run
/// and cost half as much again to compile.
template <int D, class Work>
[[gnu::always_inline]] inline auto apart_in_space(const Work& work) {
  if constexpr (D == 3)
    return apart(work);
  else
    return work();
}

/// The nodes that a group of particles shares, K along each axis, with the weights of each particle. Lanes are
/// particles: what is gathered is theirs, four at a time, and what a group adds to a node is summed over all of it
/// first.
///
/// Its loops go line by line of nodes along the first axis, with what fits into the processor's registers.
template <int D, int K>
class PackStencil {
 public:
  /// `place` is of the first of the pack, or of the group.
  [[gnu::always_inline]] PackStencil(const PointBlock<D, K>& block, const Grid<D>& grid, int place)
      : N_(&block.N[0][0][place]), dN_(&block.dN[0][0][place]), first_(static_cast<std::size_t>(block.first[place])) {
    for (int d = 0; d < D; ++d) stride_[static_cast<std::size_t>(d)] = grid.stride(d);
  }

  /// Σ_i N_ip φ_i
  [[gnu::always_inline]] PackVec<D> gather(const std::vector<Padded<D>>& field) const {
    return apart_in_space<D>([&] {
      PackVec<D> sum;
      for_constants<D>([&](auto c) { sum[c.value] = Pack(value<D - 1, padded_size<D>>(field[first_].data() + c)); });
      return sum;
    });
  }
  [[gnu::always_inline]] Pack gather(const std::vector<double>& field) const {
    return apart_in_space<D>([&] { return Pack(value<D - 1, 1>(&field[first_])); });
  }

  /// Σ_i N_ip φ_i and Σ_i φ_i ⊗ ∇N_ip
  [[gnu::always_inline]] PackValuesAndGradients<D> gather_with_gradient(const std::vector<Padded<D>>& field) const {
    return apart_in_space<D>([&] {
      PackValuesAndGradients<D> sum;
      for_constants<D>([&](auto c) {
        const auto of_component = value_and_gradient<D - 1>(field[first_].data() + c);
        sum.value[c.value] = Pack(of_component[D]);
        for_constants<D>([&](auto d) { sum.gradient(c.value, d.value) = Pack(of_component[d]); });
      });
      return sum;
    });
  }

  /// φ_i += Σ_p N_ip value_p of a group of so many packs
  template <int C, class V>
  [[gnu::always_inline]] void scatter(const PackVec<C>* source, int packs, std::vector<V>& field) const {
    apart_in_space<D>([&] {
      for_lines([&](const Line& line) {
        std::array<Lanes, K * C> sum{};
        for (int at = 0; at < lanes * packs; at += lanes) {
          const Lanes weight = line_weight(line, at);
          const PackVec<C>& value = source[at / lanes];
          for_constants<C>([&](auto c) {
            const Lanes of_line = weight * value[c.value].of;
            for_constants<K>([&](auto i) { sum[i * C + c] += N(0, i, at) * of_line; });
          });
        }
        add<C>(sum, line, field);
      });
    });
  }

  /// φ_i += Σ_p (N_ip value_p + gradient_p ∇N_ip) of a group of so many packs
  [[gnu::always_inline]] void scatter(const PackValuesAndGradients<D>* source, int packs,
                                      std::vector<Padded<D>>& field) const {
    apart_in_space<D>([&] {
      for_lines([&](const Line& line) {
        std::array<Lanes, K * D> sum{};
        for (int at = 0; at < lanes * packs; at += lanes) {
          const PackValuesAndGradients<D>& of_pack = source[at / lanes];
          const Lanes weight = line_weight(line, at);
          for_constants<D>([&](auto c) {
            const Lanes slope = weight * of_pack.gradient(c.value, 0).of;
            Lanes value = weight * of_pack.value[c.value].of;
            for_constants<D - 1>(
                [&](auto d) { value += line_slope(line, d + 1, at) * of_pack.gradient(c.value, d.value + 1).of; });
            for_constants<K>([&](auto i) {
              sum[i * D + c] += N(0, i, at) * value;
              sum[i * D + c] += dN(0, i, at) * slope;
            });
          });
        }
        add<D>(sum, line, field);
      });
    });
  }

 private:
  static constexpr int row = PointBlock<D, K>::most;

  /// Σ_i N_ip φ_i over the axes up to `axis`, of one component of a field with so many
  template <int axis, int components>
  [[gnu::always_inline]] Lanes value(const double* nodes) const {
    const auto part = [&](int i) {
      if constexpr (axis == 0)
        return N(0, i, 0) * nodes[i * components];
      else
        return N(axis, i, 0) * value<axis - 1, components>(nodes + i * stride_[axis] * components);
    };
    Lanes sum = part(0);
    for (int i = 1; i < K; ++i) sum += part(i);
    return sum;
  }

  /// Σ_i φ_i ∇N_ip over the axes up to `axis`, and then Σ_i N_ip φ_i, of one component
  template <int axis>
  [[gnu::always_inline]] std::array<Lanes, axis + 2> value_and_gradient(const double* nodes) const {
    std::array<Lanes, axis + 2> sum{};
    for (int i = 0; i < K; ++i) {
      if constexpr (axis == 0) {
        sum[0] += dN(0, i, 0) * nodes[i * padded_size<D>];
        sum[1] += N(0, i, 0) * nodes[i * padded_size<D>];
      } else {
        const auto part = value_and_gradient<axis - 1>(nodes + i * stride_[axis] * padded_size<D>);
        for_constants<axis>([&](auto d) { sum[d] += N(axis, i, 0) * part[d]; });
        sum[axis] += dN(axis, i, 0) * part[axis];
        sum[axis + 1] += N(axis, i, 0) * part[axis];
      }
    }
    return sum;
  }

  /// The nodes along the first axis with the same places along the others.
  struct Line {
    std::array<int, 3> i{};
    std::ptrdiff_t offset = 0;  ///< of its first node from the first of all, in nodes
  };

  template <class Visit>
  [[gnu::always_inline]] void for_lines(const Visit& visit) const {
    if constexpr (D == 1)
      visit(Line{});
    else if constexpr (D == 2)
      for (int j = 0; j < K; ++j) visit(Line{{0, j, 0}, j * stride_[1]});
    else
      for (int k = 0; k < K; ++k)
        for (int j = 0; j < K; ++j) visit(Line{{0, j, k}, j * stride_[1] + k * stride_[2]});
  }

  [[gnu::always_inline]] Lanes N(int axis, int i, int at) const { return load_lanes(N_ + (axis * K + i) * row + at); }
  [[gnu::always_inline]] Lanes dN(int axis, int i, int at) const { return load_lanes(dN_ + (axis * K + i) * row + at); }

  /// The product of the weights along the other axes, and with the gradient along one of them.
  [[gnu::always_inline]] Lanes line_weight(const Line& line, int at) const {
    if constexpr (D == 1) return 1 - Lanes{};
    if constexpr (D == 2) return N(1, line.i[1], at);
    if constexpr (D == 3) return N(1, line.i[1], at) * N(2, line.i[2], at);
  }
  [[gnu::always_inline]] Lanes line_slope(const Line& line, int axis, int at) const {
    if constexpr (D < 3) return dN(1, line.i[1], at);
    if constexpr (D == 3)
      return axis == 1 ? dN(1, line.i[1], at) * N(2, line.i[2], at) : N(1, line.i[1], at) * dN(2, line.i[2], at);
  }

  template <int C, class V>
  [[gnu::always_inline]] void add(const std::array<Lanes, K * C>& sum, const Line& line,
                                  std::vector<V>& field) const {
    static_assert(padded_size<C> == V::RowsAtCompileTime);
    double* const nodes = field[first_].data() + padded_size<C> * line.offset;
    for_constants<K>([&](auto i) { add_sums<C>(&sum[i * C], nodes + i * padded_size<C>); });
  }

  const double *N_, *dN_;
  std::size_t first_;  ///< storage index of the first node
  std::array<std::ptrdiff_t, D> stride_;
};

}  // namespace mpmvv::solver
