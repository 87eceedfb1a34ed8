#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "solver/array.hpp"
#include "solver/simd/pack.hpp"
#include "solver/stencils/point_block.hpp"
#include "solver/stencils/stencil.hpp"

namespace mpmvv::solver {

/// The nodes of four particles of a bar that are neighbours in their block: the K nodes of the first particle, and
/// `more` nodes beyond them that others reach. Each node has a pack of weights, zero for the particles that do not
/// reach it, and is read and written once for all four.
template <int K, int more>
struct PackStencil {
  static constexpr int nodes = K + more;
  /// For each s: which of the four particles have their first node s nodes after that of the first particle.
  using Starts = std::array<Mask4, more + 1>;

  std::size_t first;  ///< storage index of the first node
  std::array<Pack, nodes> N, dN;

  /// Puts together the stencils of the four particles of the block from the k-th on.
  template <bool with_gradients>
  [[gnu::always_inline]] static PackStencil of(const PointBlock<1, K>& block, int k, const Starts& starts) {
    constexpr auto each_node = std::make_integer_sequence<int, nodes>{};
    PackStencil stencil{static_cast<std::size_t>(block.first[k]), on_nodes(block.N[0], k, starts, each_node), {}};
    if constexpr (with_gradients) stencil.dN = on_nodes(block.dN[0], k, starts, each_node);
    return stencil;
  }

  /// Returns Σ_i N_ip φ_i.
  [[gnu::always_inline]] PackVec<1> gather(const Array<Padded<1>>& field) const { return PackVec<1>(sum(N, field)); }
  /// Returns Σ_i N_ip φ_i and Σ_i φ_i ∇N_ip.
  [[gnu::always_inline]] ValueAndGradient<1, Pack> gather_with_gradient(const Array<Padded<1>>& field) const {
    return {PackVec<1>(sum(N, field)), PackVec<1>(sum(dN, field))};
  }

  /// φ_i += Σ_p N_ip value_p
  template <int C>
  [[gnu::always_inline]] void scatter(const PackVec<C>& value, Array<Eigen::Matrix<double, C, 1>>& field) const {
    Pack parts[nodes * C];
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t c = 0; c < C; ++c) parts[i * C + c] = N[i] * value.data()[c];
    add_sums(parts, field[first].data());
  }
  /// φ_i += Σ_p (N_ip value_p + gradient_p ∇N_ip)
  [[gnu::always_inline]] void scatter(const ValueAndGradient<1, Pack>& source, Array<Padded<1>>& field) const {
    Pack parts[nodes];
    for (std::size_t i = 0; i < nodes; ++i) parts[i] = N[i] * source.value[0] + dN[i] * source.gradient(0, 0);
    add_sums(parts, field[first].data());
  }

 private:
  using Rows = double[K][PointBlock<1, K>::most];

  template <int... i>
  [[gnu::always_inline]] static std::array<Pack, nodes> on_nodes(const Rows& weights, int k, const Starts& starts,
                                                                 std::integer_sequence<int, i...>) {
    return {on_node<i>(weights, k, starts)...};
  }
  template <int i>
  [[gnu::always_inline]] static Pack on_node(const Rows& weights, int k, const Starts& starts) {
    constexpr int nearest = std::max(0, i - K + 1), farthest = std::min(i, more);  // starts s that reach node i
    constexpr bool by_all = nearest == 0 && farthest == more;
    Double4 weight = by_all ? load4(&weights[i][k]) : Double4{};
    for (int s = nearest + by_all; s <= farthest; ++s)
      weight = starts[static_cast<std::size_t>(s)] ? load4(&weights[i - s][k]) : weight;
    return Pack(weight);
  }
  [[gnu::always_inline]] Pack sum(const std::array<Pack, nodes>& weights, const Array<Padded<1>>& field) const {
    const double* const values = field[first].data();
    Pack total = weights[0] * Pack(values[0]);
    for (std::size_t i = 1; i < nodes; ++i) total += weights[i] * Pack(values[i]);
    return total;
  }
  /// to[i] += Σ_p parts[i]_p
  template <int n>
  [[gnu::always_inline]] static void add_sums(const Pack (&parts)[n], double* to) {
    constexpr int rest = n % 4, before = n - rest;
    for (int i = 0; i < before; i += 4)
      store4(load4(to + i) + sums(parts[i].of, parts[i + 1].of, parts[i + 2].of, parts[i + 3].of), to + i);
    if constexpr (rest > 0) {
      const auto part = [&](int i) { return i < rest ? parts[before + i].of : Double4{}; };
      const Double4 last = sums(part(0), part(1), part(2), part(3));
      for (int i = 0; i < rest; ++i) to[before + i] += last[i];
    }
  }
};

/// Whether the particles of a block are points of a bar, so that four can be visited at once.
template <class Shape>
inline constexpr bool is_line = false;
template <int K>
inline constexpr bool is_line<PointBlock<1, K>> = true;

/// Calls visit(nodes) once for the four particles from the k-th on, if the first node of each lies 0 to 2 nodes after
/// that of the k-th particle. Returns whether it did.
template <bool with_gradients, int K>
[[gnu::always_inline]] inline bool visit_together(const PointBlock<1, K>& block, int k, const auto& visit) {
  const Int4 nodes = load4(block.first + k) - block.first[k];
  const Mask4 after = __builtin_convertvector(nodes, Mask4), by_0 = after == 0, by_1 = after == 1, by_2 = after == 2;
  if (all(by_0))
    visit(PackStencil<K, 0>::template of<with_gradients>(block, k, {by_0}));
  else if (all(by_0 | by_1))
    visit(PackStencil<K, 1>::template of<with_gradients>(block, k, {by_0, by_1}));
  else if (all(by_0 | by_1 | by_2))
    visit(PackStencil<K, 2>::template of<with_gradients>(block, k, {by_0, by_1, by_2}));
  else
    return false;
  return true;
}

}  // namespace mpmvv::solver
