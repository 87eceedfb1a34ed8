#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "solver/stencils/tile.hpp"

/// Groups of particles, one after the other, that reach the same nodes: each is visited in packs of four.
namespace mpmvv::solver {

using StoredInts [[gnu::vector_size(32), gnu::aligned(4)]] = int;

/// The bits that are set in one of eight.
[[gnu::always_inline]] inline unsigned united(StoredInts of) {
  of |= __builtin_shufflevector(of, of, 4, 5, 6, 7, 0, 1, 2, 3);
  of |= __builtin_shufflevector(of, of, 2, 3, 0, 1, 6, 7, 4, 5);
  return static_cast<unsigned>(of[0] | of[1]);
}

/// Lists a tile's groups.
template <int D>
void find_groups(Tile<D>& tile) {
  constexpr StoredInts bits{1, 2, 4, 8, 16, 32, 64, 128};
  std::array<std::uint64_t, static_cast<std::size_t>(Tile<D>::most) / 64> ends{};  // particles after which one ends
  static_assert(Tile<D>::most % 64 == 0, "a tile's size is a whole number of words");
  const auto eight_from = [&tile](int k) { return *reinterpret_cast<const StoredInts*>(&tile.first[k]); };
  for (int k = 0; k < tile.count; k += 8) {
    const std::uint64_t eight = united((eight_from(k) != eight_from(k + 1)) & bits);
    ends[static_cast<std::size_t>(k) / 64] |= eight << (k % 64);
  }
  tile.groups = tile.group[0] = 0;
  for (std::size_t w = 0; 64 * static_cast<int>(w) < tile.count; ++w)
    for (std::uint64_t left = ends[w]; left != 0; left &= left - 1)
      tile.group[++tile.groups] = static_cast<int>(64 * w) + std::countr_zero(left) + 1;
  while (tile.groups > 0 && tile.group[tile.groups] >= tile.count) --tile.groups;
  tile.group[++tile.groups] = tile.count;
}

/// What a visit to a tile takes: so many packs, and the nodes of so many groups.
template <int D>
int count_visits(const Tile<D>& tile) {
  int packs = 0;
  for (int g = 0; g < tile.groups; ++g) packs += (tile.group[g + 1] - tile.group[g] + 3) / 4;
  return packs + tile.groups;
}

/// The different first nodes of a tile's groups, numbered in the order in which they appear.
class NodeNumbers {
 public:
  NodeNumbers() { std::ranges::fill(node_, -1); }

  int count() const { return count_; }
  int of(int node) {
    std::size_t slot = (static_cast<std::uint32_t>(node) * 2654435769U) >> 22;
    while (node_[slot] != node && node_[slot] != -1) slot = (slot + 1) % slots;
    if (node_[slot] == -1) node_[slot] = node, number_[slot] = count_++;
    return number_[slot];
  }

 private:
  static constexpr std::size_t slots = 1024;
  static_assert(slots > most_in_tile);
  int node_[slots], number_[slots];
  int count_ = 0;
};

/// Brings those of a tile that reach the same nodes together, where groups do so in turn.
template <int D>
[[gnu::noinline]] void group_by_stencil(Tile<D>& tile) {
  NodeNumbers numbers;
  int number[Tile<D>::most], place[Tile<D>::most + 1]{}, to[Tile<D>::most];
  for (int g = 0; g < tile.groups; ++g) {
    number[g] = numbers.of(tile.first[tile.group[g]]);
    place[number[g] + 1] += tile.group[g + 1] - tile.group[g];
  }
  for (int n = 0; n < numbers.count(); ++n) place[n + 1] += place[n];
  for (int g = 0; g < tile.groups; ++g) {
    to[g] = place[number[g]];
    place[number[g]] += tile.group[g + 1] - tile.group[g];
  }
  const auto reorder = [&]<class T>(T* values) {
    T sorted[Tile<D>::most];
    for (int g = 0; g < tile.groups; ++g)
      for (int k = tile.group[g]; k < tile.group[g + 1]; ++k) sorted[to[g] + k - tile.group[g]] = values[k];
    for (int k = 0; k < tile.count; ++k) values[k] = sorted[k];
  };
  reorder(tile.particle);
  reorder(tile.first);
  for (int d = 0; d < D; ++d) reorder(tile.xi[d]), reorder(tile.width[d]);
  find_groups(tile);
}

}  // namespace mpmvv::solver
