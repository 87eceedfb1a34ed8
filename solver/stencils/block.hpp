#pragma once
#include <cstddef>
#include <cstdint>

#include "solver/simd/lanes.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

/// Places for particles, a whole number of packs.
template <int D>
inline constexpr int block_size = D == 1 ? 128 : 64;

/// A matrix of each particle of a block: entry by entry where they are visited in packs, else one by one.
template <int D>
struct MatrixBlock {
  alignas(64) double entry[D][D][block_size<D>];
  PaddedMat<D> each[block_size<D>];
};

/// A few particles of a slab, in packs of `lanes`. The first places of each pack have particles of their own; the others
/// name particles of the slab, for what is read there and dropped.
template <int D>
struct PackList {
  static constexpr int most_packs = block_size<D> / lanes;

  int packs;
  std::uint32_t particle[block_size<D>];  ///< at each place
  int filled[most_packs];                 ///< of each pack, the places with particles of their own
  bool is_grouped;                        ///< whether those that share their nodes are visited together, in packs
  int groups;                             ///< of packs that share their nodes, where they are
  int group[most_packs + 1];              ///< the pack with which each begins, and the end

  int places() const { return packs * lanes; }
  bool is_filled(int place) const { return place % lanes < filled[place / lanes]; }
};

/// The particles that a sweep visits together, and what its kernels hand to each other.
template <int D>
struct Block : PackList<D> {
  explicit Block(int of_slab) : slab(of_slab) {}  // leaves the rest unset: each is written before it is read

  int slab;
  MatrixBlock<D> tau;       ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size<D>];  ///< body acceleration, by EvaluateBodyForce
};

/// Calls visit(p, k) for every particle p of a block and its place k.
template <int D, class Visit>
[[gnu::always_inline]] inline void for_particles(const PackList<D>& block, const Visit& visit) {
  for (int pack = 0; pack < block.packs; ++pack)
    for (int k = pack * lanes; k < pack * lanes + block.filled[pack]; ++k)
      visit(static_cast<std::size_t>(block.particle[k]), k);
}

/// The block of one particle.
template <int D>
void hold_alone(std::size_t particle, PackList<D>& block) {
  block.packs = 1;
  block.filled[0] = 1;
  block.is_grouped = false;
  for (int k = 0; k < lanes; ++k) block.particle[k] = static_cast<std::uint32_t>(particle);
}

}  // namespace mpmvv::solver
