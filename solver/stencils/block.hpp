#pragma once
#include <cstddef>

#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

template <int D>
inline constexpr int block_size = D == 1 ? 128 : 64;

/// Whether a block of this size has room for packs of four. The last pack is stored whole, also beyond the last
/// particle.
constexpr bool has_room_for_packs(int size) {
  return size % 4 == 0;
}

/// Some neighbouring particles of a slab, and the data that the kernels of a sweep pass on to each other.
template <int D>
struct Block {
  static_assert(has_room_for_packs(block_size<D>));

  explicit Block(int of_slab) : slab(of_slab) {}  // leaves the other members unset: each is written before it is read

  /// Returns the number of particles, rounded up to whole packs.
  int padded_count() const { return (count + 3) / 4 * 4; }

  int slab;
  std::size_t begin;                ///< index of the first particle
  int count;                        ///< number of particles
  PaddedMat<D> L[block_size<D>];    ///< velocity gradient, 1/s, set by kernels/update_particles.hpp
  PaddedMat<D> tau[block_size<D>];  ///< Kirchhoff stress, Pa, set by EvaluateStress
  Vec<D> b[block_size<D>];          ///< body force per mass, m/s², set by EvaluateBodyForce
};

}  // namespace mpmvv::solver
