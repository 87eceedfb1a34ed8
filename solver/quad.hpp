#pragma once
#include <array>
#include <cstddef>

namespace mpmvv::solver {

/// Four and two numbers in a vector register, where the processor has such wide ones.
using Quad [[gnu::vector_size(32)]] = double;
using Pair [[gnu::vector_size(16)]] = double;

// In memory, where they need not be aligned; as doubles, so that a store changes nothing but those.
using StoredQuad [[gnu::vector_size(32), gnu::aligned(8)]] = double;
using StoredPair [[gnu::vector_size(16), gnu::aligned(8)]] = double;

[[gnu::always_inline]] inline Quad load_quad(const double* from) {
  return *reinterpret_cast<const StoredQuad*>(from);
}

/// C components of each of four particles.
template <int C>
struct Quads {
  std::array<Quad, C> c;

  [[gnu::always_inline]] friend Quads operator*(const Quad& factor, const Quads& quads) {
    if constexpr (C == 1)
      return {{factor * quads.c[0]}};
    else
      return {{factor * quads.c[0], factor * quads.c[1]}};
  }

  [[gnu::always_inline]] void operator+=(const Quads& other) {
    c[0] += other.c[0];
    if constexpr (C == 2) c[1] += other.c[1];
  }

  /// Adds the sums over the particles to a node's components.
  [[gnu::always_inline]] void add_sums(double* node) const {
    if constexpr (C == 1) {
      const Pair halves = half(c[0], 0) + half(c[0], 1);
      *node += halves[0] + halves[1];
    } else {
      const Quad halves = __builtin_shufflevector(c[0], c[1], 0, 4, 2, 6) +  // x₀ y₀ x₂ y₂
                          __builtin_shufflevector(c[0], c[1], 1, 5, 3, 7);   // x₁ y₁ x₃ y₃
      *reinterpret_cast<StoredPair*>(node) += half(halves, 0) + half(halves, 1);
    }
  }

 private:
  [[gnu::always_inline]] static Pair half(const Quad& q, int which) {
    return which == 0 ? __builtin_shufflevector(q, q, 0, 1) : __builtin_shufflevector(q, q, 2, 3);
  }
};

}  // namespace mpmvv::solver
