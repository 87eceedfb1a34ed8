#pragma once
#include <cstddef>

#include "solver/types.hpp"

namespace mpmvv::solver {

template <int D>
inline constexpr int block_size = D == 1 ? 128 : 64;

/// A matrix of each particle of a block: entry by entry where they go in companies, else one by one. With room for four
/// at the last.
template <int D>
struct MatrixBlock {
  alignas(32) double entry[D][D][block_size<D> + 4];
  PackedMat<D> each[block_size<D> + 4];
};

/// A few neighbouring particles, and what the stages of a sweep hand to each other.
template <int D>
struct Block {
  int slab;
  std::size_t begin;
  int count;
  bool in_companies;        ///< whether those that share their nodes are visited together
  MatrixBlock<D> tau;       ///< Kirchhoff stress, by EvaluateStress
  Vec<D> b[block_size<D>];  ///< body acceleration, by EvaluateBodyForce
};

/// What a sweep evaluates at its particles' nodes: many operations use no gradients.
enum class Evaluates { weights, weights_and_gradients };

}  // namespace mpmvv::solver
