#pragma once
#include <cstddef>

#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

template <int D>
inline constexpr int block_size = D == 1 ? 128 : 64;

/// A few neighbouring particles of a slab, and what the kernels of a sweep hand to each other.
template <int D>
struct Block {
  explicit Block(int of_slab) : slab(of_slab) {}  // leaves the rest unset: each is written before it is read

  int slab;
  std::size_t begin;                ///< the first particle
  int count;                        ///< of particles
  PaddedMat<D> L[block_size<D>];    ///< velocity gradient, per s, by kernels/update_particles.hpp
  PaddedMat<D> tau[block_size<D>];  ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size<D>];          ///< body acceleration, by EvaluateBodyForce
};

}  // namespace mpmvv::solver
