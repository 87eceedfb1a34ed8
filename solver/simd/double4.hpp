#pragma once
namespace mpmvv::solver {

/// Four and two numbers in a vector register, where the processor has such wide ones. As the scalar of Eigen's matrices
/// std::experimental::fixed_size_simd<double, 4> took 1.6 times the instructions in the plane and 1.4 times in space
/// (the loops of a step alone, g++ 12, x86-64-v3); native_simd took 1.06 times, and has four lanes only where there is
/// AVX.
using Double4 [[gnu::vector_size(32)]] = double;
using Double2 [[gnu::vector_size(16)]] = double;

// In memory, where they need not be aligned; as doubles, so that a store changes nothing but those.
using StoredDouble4 [[gnu::vector_size(32), gnu::aligned(8)]] = double;
using StoredDouble2 [[gnu::vector_size(16), gnu::aligned(8)]] = double;

[[gnu::always_inline]] inline Double4 load4(const double* from) {
  return *reinterpret_cast<const StoredDouble4*>(from);
}
[[gnu::always_inline]] inline void store4(const Double4& four, double* to) {
  *reinterpret_cast<StoredDouble4*>(to) = four;
}
[[gnu::always_inline]] inline Double2 load2(const double* from) {
  return *reinterpret_cast<const StoredDouble2*>(from);
}
[[gnu::always_inline]] inline void store2(const Double2& pair, double* to) {
  *reinterpret_cast<StoredDouble2*>(to) = pair;
}
[[gnu::always_inline]] inline Double4 joined(const Double2& low, const Double2& high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
[[gnu::always_inline]] inline Double2 half(const Double4& q, int which) {
  return which == 0 ? __builtin_shufflevector(q, q, 0, 1) : __builtin_shufflevector(q, q, 2, 3);
}
/// a₀+a₁, b₀+b₁, a₂+a₃, b₂+b₃
[[gnu::always_inline]] inline Double4 sums_of_neighbours(const Double4& a, const Double4& b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
}

}  // namespace mpmvv::solver
