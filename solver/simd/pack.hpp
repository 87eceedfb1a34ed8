#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <utility>

#include "solver/simd/lanes.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

/// A number of each of a few particles: a scalar for Eigen, whose vectors and matrices then hold those of all of them.
struct Pack {
  Lanes of;

  Pack() = default;
  [[gnu::always_inline]] Pack(double same) : of(same - Lanes{}) {}
  [[gnu::always_inline]] explicit Pack(const Lanes& each) : of(each) {}

  double operator[](std::size_t lane) const { return of[lane]; }

  [[gnu::always_inline]] friend Pack operator+(const Pack& a, const Pack& b) { return Pack(Lanes(a.of + b.of)); }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a, const Pack& b) { return Pack(Lanes(a.of - b.of)); }
  [[gnu::always_inline]] friend Pack operator*(const Pack& a, const Pack& b) { return Pack(Lanes(a.of * b.of)); }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a) { return Pack(Lanes(-a.of)); }
  [[gnu::always_inline]] Pack& operator+=(const Pack& b) { return of += b.of, *this; }
  [[gnu::always_inline]] Pack& operator-=(const Pack& b) { return of -= b.of, *this; }
  [[gnu::always_inline]] Pack& operator*=(const Pack& b) { return of *= b.of, *this; }
};

/// Calls visit(k) for k = 0, ..., n-1, each a constant: what it indexes stays in registers.
template <int n, class Visit>
[[gnu::always_inline]] inline void for_constants(const Visit& visit) {
  [&visit]<int... k>(std::integer_sequence<int, k...>) {
    (visit(std::integral_constant<int, k>{}), ...);
  }
  (std::make_integer_sequence<int, n>{});
}

/// Each moved into [least, most], a NaN to `least`; true in `strays` for those that had to be moved.
[[gnu::always_inline]] inline Pack confined(const Pack& each, double least, double most, LaneMask& strays) {
  const Lanes low = Pack(least).of, high = Pack(most).of;
  const Lanes raised = each.of > low ? each.of : low;
  const Lanes inside = raised < high ? raised : high;
  strays |= inside != each.of;
  return Pack(inside);
}

/// ln x of x in [1/2, 2]. With f = x - 1 and s = f/(2 + f) it is 2 artanh s = f - s (f - R), where R = 2 (artanh s
/// - s)/s is s² times the polynomial in s² that is nearest to it on [0, 1/9], to 2^-59 of ln x.
[[gnu::always_inline]] inline Lanes log_near_one(const Lanes& x) {
  const Lanes f = x - 1., s = f / (f + 2.), z = s * s, w = z * z;
  const Lanes even =
      0.666666666666663038 +
      w * (0.285714285478537461 + w * (0.181817439246665672 + w * (0.133009735248520771 + w * 0.0834009981938704841)));
  const Lanes odd =
      0.40000000000157244 +
      w * (0.222222239697390433 + w * (0.153865599281779019 + w * (0.121060866899222885 + w * 0.170185780516948776)));
  return f - s * (f - z * (even + z * odd));
}

[[gnu::noinline]] inline Pack log_of_any(const Pack& each) {
  using Array = Eigen::Array<double, lanes, 1>;
  Pack result;
  Eigen::Map<Array>(reinterpret_cast<double*>(&result.of)) =
      Eigen::Map<const Array>(reinterpret_cast<const double*>(&each.of)).log();
  return result;
}

/// Most often of determinants of F that are near one.
[[gnu::always_inline]] inline Pack log(const Pack& each) {
  if (all((each.of >= 0.5) & (each.of <= 2.))) return Pack(log_near_one(each.of));
  return log_of_any(each);
}

template <int D>
using PackVec = Eigen::Matrix<Pack, D, 1>;

template <int D>
using PackMat = Eigen::Matrix<Pack, D, D>;

/// Particles' n numbers each, entry by entry.
template <int n>
[[gnu::always_inline]] inline void load_packs(const LaneAddresses<const double>& from, Pack* packs) {
  constexpr std::size_t other = lanes - 4;  // the lane in the place of lane 0 in the other half
  const auto fours_from = [&](std::size_t lane, int k) __attribute__((always_inline)) {
    return joined_fours(load4(from[lane] + k), load4(from[lane + other] + k));
  };
  const auto pairs_from = [&](std::size_t lane, int k) __attribute__((always_inline)) {
    return joined_fours(joined(load2(from[lane] + k), load2(from[lane + 2] + k)),
                        joined(load2(from[lane + other] + k), load2(from[lane + other + 2] + k)));
  };
  constexpr int fours = n / 4 * 4, pairs = n / 2 * 2;
#pragma GCC unroll 4
  for (int k = 0; k < fours; k += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) packs[k + static_cast<int>(lane)].of = fours_from(lane, k);
    transpose_fours(packs[k].of, packs[k + 1].of, packs[k + 2].of, packs[k + 3].of);
  }
  if constexpr (pairs > fours) {
    const Lanes even = pairs_from(0, fours), odd = pairs_from(1, fours);
    packs[fours].of = even_by_turns(even, odd), packs[fours + 1].of = odd_by_turns(even, odd);
  }
  if constexpr (n > pairs)
    for (std::size_t lane = 0; lane < lanes; ++lane) packs[pairs].of[lane] = from[lane][pairs];
}
template <int n>
[[gnu::always_inline]] inline void store_packs(const Pack* packs, const LaneAddresses<double>& to) {
  constexpr std::size_t other = lanes - 4;
  constexpr int fours = n / 4 * 4, pairs = n / 2 * 2;
#pragma GCC unroll 4
  for (int k = 0; k < fours; k += 4) {
    std::array<Lanes, 4> rows{packs[k].of, packs[k + 1].of, packs[k + 2].of, packs[k + 3].of};
    transpose_fours(rows[0], rows[1], rows[2], rows[3]);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      store4(low_four(rows[lane]), to[lane] + k);
      if (other > 0) store4(high_four(rows[lane]), to[lane + other] + k);
    }
  }
  if constexpr (pairs > fours) {
    const auto store_pairs = [&](const Lanes& rows, std::size_t lane) __attribute__((always_inline)) {
      store2(half(low_four(rows), 0), to[lane] + fours), store2(half(low_four(rows), 1), to[lane + 2] + fours);
      if (other == 0) return;
      store2(half(high_four(rows), 0), to[lane + other] + fours);
      store2(half(high_four(rows), 1), to[lane + other + 2] + fours);
    };
    store_pairs(even_by_turns(packs[fours].of, packs[fours + 1].of), 0);
    store_pairs(odd_by_turns(packs[fours].of, packs[fours + 1].of), 1);
  }
  if constexpr (n > pairs)
    for (std::size_t lane = 0; lane < lanes; ++lane) to[lane][pairs] = packs[pairs].of[lane];
}

/// The vectors with one more component.
template <int D>
[[gnu::always_inline]] inline PackVec<D + 1> padded(const PackVec<D>& vector, const Pack& last) {
  PackVec<D + 1> longer;
  longer.template head<D>() = vector;
  longer[D] = last;
  return longer;
}

template <int D>
[[gnu::always_inline]] inline PackVec<D + 1> padded_alone(const Pack& last) {
  return padded<D>(PackVec<D>(PackVec<D>::Zero()), last);
}

/// Those to be kept, and zero for the others whatever they are.
template <int R, int C>
[[gnu::always_inline]] inline void set_first(const Eigen::Matrix<Pack, R, C>& packs, const LaneMask& kept, Eigen::Matrix<Pack, R, C>& to) {
#pragma GCC unroll 16
  for (int k = 0; k < R * C; ++k) to(k) = Pack(Lanes(LaneMask(packs(k).of) & kept));
}

/// Adds the sums over all lanes to a node, whose padding may change.
template <int C>
[[gnu::always_inline]] inline void add_sums(const Lanes* q, double* node) {
  if constexpr (C == 1) {
    const Double4 sum = sum_of_fours(q[0]);
    const Double2 halves = half(sum, 0) + half(sum, 1);
    *node += halves[0] + halves[1];
  } else {
    const Double4 low = sums_of_neighbours(sum_of_fours(q[0]), sum_of_fours(q[1]));
    if constexpr (C == 2) {
      *reinterpret_cast<StoredDouble2*>(node) += half(low, 0) + half(low, 1);
    } else {
      const Double4 high = sums_of_neighbours(sum_of_fours(q[2]), sum_of_fours(q[C - 1]));
      *reinterpret_cast<StoredDouble4*>(node) +=
          __builtin_shufflevector(low, high, 0, 1, 4, 5) + __builtin_shufflevector(low, high, 2, 3, 6, 7);
    }
  }
}

}  // namespace mpmvv::solver

template <>
struct Eigen::NumTraits<mpmvv::solver::Pack> {
  using Real = mpmvv::solver::Pack;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};

template <class Op>
struct Eigen::ScalarBinaryOpTraits<double, mpmvv::solver::Pack, Op> {
  using ReturnType = mpmvv::solver::Pack;
};
template <class Op>
struct Eigen::ScalarBinaryOpTraits<mpmvv::solver::Pack, double, Op> {
  using ReturnType = mpmvv::solver::Pack;
};
