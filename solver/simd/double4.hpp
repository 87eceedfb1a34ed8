#pragma once
namespace mpmvv::solver {

/// Four or two numbers in a vector register, where the processor has registers of this width. The types of
/// std::experimental took more instructions as the scalar of Eigen's matrices: fixed_size_simd<double, 4> took 1.6
/// times as many in the plane and 1.4 times in space (the loops of a step alone, g++ 12, x86-64-v3); native_simd took
/// 1.06 times as many, and has four lanes only where there is AVX.
using Double4 [[gnu::vector_size(32)]] = double;
using Double2 [[gnu::vector_size(16)]] = double;

/// The result of comparing two `Double4`: for each of the four numbers -1 (true) or 0 (false).
using Mask4 [[gnu::vector_size(32)]] = long long;

using Int4 [[gnu::vector_size(16)]] = int;

// Four numbers in memory, which need not be aligned. These are vectors of doubles or ints, so that the compiler knows
// that a store through one changes nothing but doubles or ints.
using StoredDouble4 [[gnu::vector_size(32), gnu::aligned(8)]] = double;
using StoredInt4 [[gnu::vector_size(16), gnu::aligned(4)]] = int;

[[gnu::always_inline]] inline Double4 load4(const double* from) {
  return *reinterpret_cast<const StoredDouble4*>(from);
}
[[gnu::always_inline]] inline Int4 load4(const int* from) {
  return *reinterpret_cast<const StoredInt4*>(from);
}
[[gnu::always_inline]] inline void store4(const Double4& four, double* to) {
  *reinterpret_cast<StoredDouble4*>(to) = four;
}
[[gnu::always_inline]] inline void store4(const Int4& four, int* to) {
  *reinterpret_cast<StoredInt4*>(to) = four;
}
[[gnu::always_inline]] inline Double2 half(const Double4& a, int which) {
  return which == 0 ? __builtin_shufflevector(a, a, 0, 1) : __builtin_shufflevector(a, a, 2, 3);
}
/// Returns four sums: of the four numbers of a, of those of b, of c and of d.
[[gnu::always_inline]] inline Double4 sums(const Double4& a, const Double4& b, const Double4& c, const Double4& d) {
  const Double4 ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Double4 cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}
/// Transposes the matrix whose rows are a, b, c and d.
[[gnu::always_inline]] inline void transpose(Double4& a, Double4& b, Double4& c, Double4& d) {
  const Double4 ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Double4 cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5), b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7), d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

}  // namespace mpmvv::solver
