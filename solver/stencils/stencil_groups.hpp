#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Groups of particles of a block, one after the other, that reach the same nodes: each is visited in packs of four.
namespace mpmvv::solver {

using StoredInts [[gnu::vector_size(32), gnu::aligned(4)]] = int;

/// The bits that are set in one of eight.
[[gnu::always_inline]] inline unsigned united(StoredInts of) {
  of |= __builtin_shufflevector(of, of, 4, 5, 6, 7, 0, 1, 2, 3);
  of |= __builtin_shufflevector(of, of, 2, 3, 0, 1, 6, 7, 4, 5);
  return static_cast<unsigned>(of[0] | of[1]);
}

/// As bits, the particles after which a group ends.
template <class Block>
using GroupEnds = std::array<std::uint64_t, static_cast<std::size_t>(Block::most) / 64>;

template <class Block>
GroupEnds<Block> find_group_ends(const Block& block) {
  static_assert(Block::most % 64 == 0, "a block's size is a whole number of words");
  static_assert(Block::most < Block::room, "the place after the last particle is read, and its bit dropped");
  constexpr StoredInts bits{1, 2, 4, 8, 16, 32, 64, 128};
  const auto eight_from = [&block](int k) { return *reinterpret_cast<const StoredInts*>(&block.first[k]); };
  GroupEnds<Block> ends{};
  for (int k = 0; k < block.count; k += 8) {
    const std::uint64_t eight = united((eight_from(k) != eight_from(k + 1)) & bits);
    ends[static_cast<std::size_t>(k) / 64] |= eight << (k % 64);
  }
  const auto last = static_cast<std::size_t>(block.count - 1);
  ends[last / 64] &= (std::uint64_t{2} << (last % 64)) - 1;
  ends[last / 64] |= std::uint64_t{1} << (last % 64);
  return ends;
}

/// Lists the groups and counts their packs.
template <class Block>
int list_groups(Block& block, const GroupEnds<Block>& ends) {
  int groups = 0, packs = 0, begin = 0;
  block.group[0] = 0;
  for (std::size_t w = 0; w < ends.size(); ++w)
    for (std::uint64_t left = ends[w]; left != 0; left &= left - 1) {
      const int end = static_cast<int>(64 * w) + std::countr_zero(left) + 1;
      packs += (end - begin + 3) / 4;
      block.group[++groups] = begin = end;
    }
  block.groups = groups;
  return packs;
}

/// Whether visits by packs pay: measured, one costs about as much as five thirds of a visit to a particle by itself,
/// and so does bringing the sums of a group to its nodes.
constexpr bool pays(int groups, int packs, int count) {
  return 5 * (packs + groups) <= 3 * count;
}

/// Decides whether the particles are visited in packs, and lists their groups then. The last group of a full block,
/// where it is shorter than the one before, is left to the next block, where it may go on.
template <class Block>
void group_by_stencil(Block& block) {
  const GroupEnds<Block> ends = find_group_ends(block);
  int groups = 0;
  for (const std::uint64_t word : ends) groups += std::popcount(word);
  block.is_grouped = pays(groups, groups, block.count) && pays(groups, list_groups(block, ends), block.count);
  if (!block.is_grouped || groups == 1 || block.count < block.most) return;
  const int* const last = block.group + groups - 1;
  if (last[1] - last[0] < last[0] - last[-1]) block.count = block.group[--block.groups];
}

}  // namespace mpmvv::solver
