#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Runs of particles of a block, one after the other, that reach the same nodes, and the companies of four that they
/// form.
namespace mpmvv::solver {

using StoredInts [[gnu::vector_size(32), gnu::aligned(4)]] = int;

/// The bits that are set in one of eight.
[[gnu::always_inline]] inline unsigned united(StoredInts of) {
  of |= __builtin_shufflevector(of, of, 4, 5, 6, 7, 0, 1, 2, 3);
  of |= __builtin_shufflevector(of, of, 2, 3, 0, 1, 6, 7, 4, 5);
  return static_cast<unsigned>(of[0] | of[1]);
}

/// As bits, the particles after which a run ends.
template <class Block>
using RunEnds = std::array<std::uint64_t, static_cast<std::size_t>(Block::most) / 64>;

template <class Block>
RunEnds<Block> find_run_ends(const Block& block) {
  static_assert(Block::most % 64 == 0, "a block's size is a whole number of words");
  static_assert(Block::most < Block::room);  // what comes after the last is read, and decides nothing
  constexpr StoredInts bits{1, 2, 4, 8, 16, 32, 64, 128};
  const auto eight_from = [&block](int k) { return *reinterpret_cast<const StoredInts*>(&block.first[k]); };
  RunEnds<Block> ends{};
  for (int k = 0; k < block.count; k += 8) {
    const std::uint64_t eight = united((eight_from(k) != eight_from(k + 1)) & bits);
    ends[static_cast<std::size_t>(k) / 64] |= eight << (k % 64);
  }
  const auto last = static_cast<std::size_t>(block.count - 1);
  ends[last / 64] &= (std::uint64_t{2} << (last % 64)) - 1;
  ends[last / 64] |= std::uint64_t{1} << (last % 64);
  return ends;
}

/// Lists the runs and counts their companies.
template <class Block>
int list_runs(Block& block, const RunEnds<Block>& ends) {
  int runs = 0, companies = 0, begin = 0;
  block.run[0] = 0;
  for (std::size_t w = 0; w < ends.size(); ++w)
    for (std::uint64_t left = ends[w]; left != 0; left &= left - 1) {
      const int end = static_cast<int>(64 * w) + std::countr_zero(left) + 1;
      companies += (end - begin + 3) / 4;
      block.run[++runs] = begin = end;
    }
  block.runs = runs;
  return companies;
}

/// Whether visits by companies pay: measured, one costs about as much as five thirds of a visit to a particle by
/// itself, and so does bringing the sums of a run to its nodes.
constexpr bool pays(int runs, int companies, int count) {
  return 5 * (companies + runs) <= 3 * count;
}

/// Decides whether the particles go in companies, and lists their runs then. The last run of a full block, where it is
/// shorter than the one before, is left to the next block, where it may go on.
template <class Block>
void form_companies(Block& block) {
  const RunEnds<Block> ends = find_run_ends(block);
  int runs = 0;
  for (const std::uint64_t word : ends) runs += std::popcount(word);
  block.in_companies = pays(runs, runs, block.count) && pays(runs, list_runs(block, ends), block.count);
  if (!block.in_companies || runs == 1 || block.count < block.most) return;
  const int* const last = block.run + runs - 1;
  if (last[1] - last[0] < last[0] - last[-1]) block.count = block.run[--block.runs];
}

}  // namespace mpmvv::solver
