#pragma once
#include <algorithm>
#include <cstdint>
#include <span>

#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

template <int D>
inline constexpr int block_size = D == 1 ? 128 : 64;

/// A matrix of each particle of a block, entry by entry, with room for a pack at the last.
template <int D>
struct MatrixBlock {
  alignas(32) double entry[D][D][block_size<D> + 4];
};

/// A few neighbouring particles of a slab, and what the kernels of a sweep hand to each other.
template <int D>
struct Block {
  explicit Block(int of_slab) : slab(of_slab) {}  // leaves the rest unset: each is written before it is read

  std::span<const std::uint32_t> particles() const { return {particle, static_cast<std::size_t>(count)}; }

  int slab;
  int count;                                  ///< of particles
  const std::uint32_t* particle;              ///< their indices, and those of a few more
  MatrixBlock<D> tau;                         ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size<D> + 4];                ///< body acceleration, by EvaluateBodyForce
};

}  // namespace mpmvv::solver
