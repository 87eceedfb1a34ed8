#pragma once
namespace mpmvv::solver {

/// Four and two numbers in a vector register, where the processor has such wide ones.
using Quad [[gnu::vector_size(32)]] = double;
using Pair [[gnu::vector_size(16)]] = double;

/// -1 or 0 for each of four: what comparing two of them gives.
using Truths [[gnu::vector_size(32)]] = long long;

// In memory, where they need not be aligned; as doubles, so that a store changes nothing but those.
using StoredQuad [[gnu::vector_size(32), gnu::aligned(8)]] = double;
using StoredPair [[gnu::vector_size(16), gnu::aligned(8)]] = double;

[[gnu::always_inline]] inline Quad load_quad(const double* from) {
  return *reinterpret_cast<const StoredQuad*>(from);
}
[[gnu::always_inline]] inline void store_quad(const Quad& quad, double* to) {
  *reinterpret_cast<StoredQuad*>(to) = quad;
}
[[gnu::always_inline]] inline Pair load_pair(const double* from) {
  return *reinterpret_cast<const StoredPair*>(from);
}
[[gnu::always_inline]] inline void store_pair(const Pair& pair, double* to) {
  *reinterpret_cast<StoredPair*>(to) = pair;
}
[[gnu::always_inline]] inline Quad joined(const Pair& low, const Pair& high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
[[gnu::always_inline]] inline Pair half(const Quad& q, int which) {
  return which == 0 ? __builtin_shufflevector(q, q, 0, 1) : __builtin_shufflevector(q, q, 2, 3);
}
/// Rows become columns.
[[gnu::always_inline]] inline void transpose(Quad& a, Quad& b, Quad& c, Quad& d) {
  const Quad ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Quad cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5), b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7), d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}
/// a₀+a₁, b₀+b₁, a₂+a₃, b₂+b₃
[[gnu::always_inline]] inline Quad sums_of_neighbours(const Quad& a, const Quad& b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
}

}  // namespace mpmvv::solver
