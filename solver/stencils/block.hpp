#pragma once
#include <cstddef>

#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

template <int D>
inline constexpr int block_size = D == 1 ? 128 : 64;

/// Whether a block of this size has room for packs of four, which are stored whole beyond the last particle, too.
constexpr bool has_room_for_packs(int size) {
  return size % 4 == 0;
}

/// A few neighbouring particles of a slab, and what the kernels of a sweep hand to each other.
template <int D>
struct Block {
  static_assert(has_room_for_packs(block_size<D>));

  explicit Block(int of_slab) : slab(of_slab) {}  // leaves the rest unset: each is written before it is read

  /// Particles up to the end of the last pack.
  int padded_count() const { return (count + 3) / 4 * 4; }

  int slab;
  std::size_t begin;                ///< the first particle
  int count;                        ///< of particles
  PaddedMat<D> L[block_size<D>];    ///< velocity gradient, per s, by kernels/update_particles.hpp
  PaddedMat<D> tau[block_size<D>];  ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size<D>];          ///< body acceleration, by EvaluateBodyForce
};

}  // namespace mpmvv::solver
