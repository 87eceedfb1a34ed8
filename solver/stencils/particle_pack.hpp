#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "solver/simd/pack.hpp"
#include "solver/stencils/block.hpp"

namespace mpmvv::solver {

/// Up to four particles, one after the other, whose fields are read at once. Where fewer are left the last is read
/// again in the place of each that is missing.
struct ParticlePack {
  std::size_t first;
  int count;

  template <int R, int C>
  [[gnu::always_inline]] auto of(const std::vector<Eigen::Matrix<double, R, C>>& field) const {
    const auto numbers = [&](int lane) {
      return field[first + static_cast<std::size_t>(count == 4 ? lane : std::min(lane, count - 1))].data();
    };
    Eigen::Matrix<Pack, R, C> packs;
    load_packs<R * C>({numbers(0), numbers(1), numbers(2), numbers(3)}, packs.data());
    return packs;
  }
};

/// Calls visit(pack, k) for every four particles of a block, the first of them at place k.
template <int D, class Visit>
[[gnu::always_inline]] inline void for_packs(const Block<D>& block, const Visit& visit) {
  int k = 0;
  const auto pack = [&](int count) { return ParticlePack{block.begin + static_cast<std::size_t>(k), count}; };
  for (; k + 4 <= block.count; k += 4) visit(pack(4), k);
  if (k < block.count) visit(pack(block.count - k), k);
}

}  // namespace mpmvv::solver
