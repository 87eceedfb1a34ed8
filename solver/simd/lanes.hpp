#pragma once
#include <array>
#include <cstddef>

#include "solver/simd/double4.hpp"

/// The widest vector register that the program is compiled for: kernels hold a number of each of so many particles in it.
namespace mpmvv::solver {

#ifdef __AVX512F__
inline constexpr int lanes = 8;
#else
inline constexpr int lanes = 4;
#endif

using Lanes [[gnu::vector_size(8 * lanes)]] = double;

/// -1 or 0 for each: what comparing two of them gives.
using LaneMask [[gnu::vector_size(8 * lanes)]] = long long;

/// As many whole numbers.
using LaneInts [[gnu::vector_size(4 * lanes)]] = int;
using StoredLaneInts [[gnu::vector_size(4 * lanes), gnu::aligned(4)]] = int;

using StoredLanes [[gnu::vector_size(8 * lanes), gnu::aligned(8)]] = double;

/// An address in each: of the same field of so many particles.
template <class T>
using LaneAddresses = std::array<T*, static_cast<std::size_t>(lanes)>;

[[gnu::always_inline]] inline Lanes load_lanes(const double* from) {
  return *reinterpret_cast<const StoredLanes*>(from);
}
[[gnu::always_inline]] inline LaneInts load_lanes(const int* from) {
  return *reinterpret_cast<const StoredLaneInts*>(from);
}
[[gnu::always_inline]] inline void store_lanes(const Lanes& all, double* to) {
  *reinterpret_cast<StoredLanes*>(to) = all;
}

/// Both, one after the other; where there are four lanes, the first alone.
template <class Wide = Lanes>
[[gnu::always_inline]] inline Wide joined_fours(const Double4& low, const Double4& high) {
  if constexpr (sizeof(Wide) == sizeof(Double4))
    return low;
  else
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// The first four lanes, and the last four.
template <class Wide>
[[gnu::always_inline]] inline Double4 low_four(const Wide& all) {
  if constexpr (sizeof(Wide) == sizeof(Double4))
    return all;
  else
    return __builtin_shufflevector(all, all, 0, 1, 2, 3);
}
template <class Wide>
[[gnu::always_inline]] inline Double4 high_four(const Wide& all) {
  if constexpr (sizeof(Wide) == sizeof(Double4))
    return all;
  else
    return __builtin_shufflevector(all, all, 4, 5, 6, 7);
}

/// From each four lanes of both those with even numbers by turns, a₀ b₀ a₂ b₂, and those with odd ones.
template <class Wide>
[[gnu::always_inline]] inline Wide even_by_turns(const Wide& a, const Wide& b) {
  if constexpr (sizeof(Wide) == sizeof(Double4))
    return __builtin_shufflevector(a, b, 0, 4, 2, 6);
  else
    return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
template <class Wide>
[[gnu::always_inline]] inline Wide odd_by_turns(const Wide& a, const Wide& b) {
  if constexpr (sizeof(Wide) == sizeof(Double4))
    return __builtin_shufflevector(a, b, 1, 5, 3, 7);
  else
    return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}

/// In each four lanes, the rows of four become columns.
[[gnu::always_inline]] inline void transpose_fours(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
  const auto halves = []<class Wide>(const Wide& x, const Wide& y, Wide& low, Wide& high) __attribute__((always_inline)) {
    if constexpr (sizeof(Wide) == sizeof(Double4)) {
      low = __builtin_shufflevector(x, y, 0, 1, 4, 5), high = __builtin_shufflevector(x, y, 2, 3, 6, 7);
    } else {
      low = __builtin_shufflevector(x, y, 0, 1, 8, 9, 4, 5, 12, 13);
      high = __builtin_shufflevector(x, y, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  };
  const Lanes ab_even = even_by_turns(a, b), ab_odd = odd_by_turns(a, b);
  const Lanes cd_even = even_by_turns(c, d), cd_odd = odd_by_turns(c, d);
  halves(ab_even, cd_even, a, c);
  halves(ab_odd, cd_odd, b, d);
}

/// The sum of its parts of four.
[[gnu::always_inline]] inline Double4 sum_of_fours(const Lanes& all) {
  if constexpr (lanes == 4)
    return low_four(all);
  else
    return low_four(all) + high_four(all);
}

/// Those before lane `count`.
[[gnu::always_inline]] inline LaneMask first_lanes(int count) {
  LaneMask numbers;
  for (int lane = 0; lane < lanes; ++lane) numbers[lane] = lane;
  return numbers < static_cast<long long>(count);
}

/// The number of each lane.
[[gnu::always_inline]] inline LaneInts lane_numbers() {
  LaneInts numbers;
  for (int lane = 0; lane < lanes; ++lane) numbers[lane] = lane;
  return numbers;
}

/// Whether all are true.
[[gnu::always_inline]] inline bool all(const LaneMask& mask) {
  long long common = -1;
  for (int lane = 0; lane < lanes; ++lane) common &= mask[lane];
  return common != 0;
}

/// Whether one is true.
template <class Mask>
[[gnu::always_inline]] inline bool any(const Mask& mask) {
  auto some = mask[0];
  for (int lane = 1; lane < lanes; ++lane) some |= mask[lane];
  return some != 0;
}

}  // namespace mpmvv::solver
