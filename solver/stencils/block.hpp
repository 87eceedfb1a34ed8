#pragma once
#include <cstddef>

#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

template <int D>
inline constexpr int block_size = D == 1 ? 128 : 64;

/// A matrix of each particle of a block: entry by entry where they are visited in packs, else one by one. With room for
/// a pack at the last.
template <int D>
struct MatrixBlock {
  alignas(32) double entry[D][D][block_size<D> + 4];
  PaddedMat<D> each[block_size<D> + 4];
};

/// A few neighbouring particles of a slab, and what the kernels of a sweep hand to each other.
template <int D>
struct Block {
  explicit Block(int of_slab) : slab(of_slab) {}  // leaves the rest unset: each is written before it is read

  int slab;
  std::size_t begin;        ///< the first particle
  int count;                ///< of particles
  bool is_grouped;          ///< whether those that share their nodes are visited together, in packs
  MatrixBlock<D> tau;       ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size<D>];  ///< body acceleration, by EvaluateBodyForce
};

}  // namespace mpmvv::solver
