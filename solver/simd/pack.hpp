#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "solver/simd/double4.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

/// A number of each of four particles: a scalar for Eigen, whose vectors and matrices then hold four of theirs.
struct Pack {
  Double4 of;

  Pack() = default;
  [[gnu::always_inline]] Pack(double same) : of{same, same, same, same} {}
  [[gnu::always_inline]] explicit Pack(const Double4& four) : of(four) {}

  double operator[](std::size_t lane) const { return of[lane]; }

  [[gnu::always_inline]] friend Pack operator+(const Pack& a, const Pack& b) { return Pack(Double4(a.of + b.of)); }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a, const Pack& b) { return Pack(Double4(a.of - b.of)); }
  [[gnu::always_inline]] friend Pack operator*(const Pack& a, const Pack& b) { return Pack(Double4(a.of * b.of)); }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a) { return Pack(Double4(-a.of)); }
  [[gnu::always_inline]] Pack& operator+=(const Pack& b) { return of += b.of, *this; }
  [[gnu::always_inline]] Pack& operator-=(const Pack& b) { return of -= b.of, *this; }
  [[gnu::always_inline]] Pack& operator*=(const Pack& b) { return of *= b.of, *this; }
};

/// Whether all are true.
[[gnu::always_inline]] inline bool all(const Mask4& mask) {
  return (mask[0] & mask[1] & mask[2] & mask[3]) != 0;
}

/// Whether one is true.
inline bool any(const Mask4& mask) {
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

/// Each moved into [least, most], a NaN to `least`; true in `strays` for those that had to be moved.
[[gnu::always_inline]] inline Pack confined(const Pack& four, double least, double most, Mask4& strays) {
  const Double4 low = Pack(least).of, high = Pack(most).of;
  const Double4 raised = four.of > low ? four.of : low;
  const Double4 inside = raised < high ? raised : high;
  strays |= inside != four.of;
  return Pack(inside);
}

/// ln x of four x in [1/2, 2]. With f = x - 1 and s = f/(2 + f) it is 2 artanh s = f - s (f - R), where R = 2 (artanh s
/// - s)/s is s² times the polynomial in s² that is nearest to it on [0, 1/9], to 2^-59 of ln x.
[[gnu::always_inline]] inline Double4 log_near_one(const Double4& x) {
  const Double4 f = x - 1., s = f / (f + 2.), z = s * s, w = z * z;
  const Double4 even =
      0.666666666666663038 +
      w * (0.285714285478537461 + w * (0.181817439246665672 + w * (0.133009735248520771 + w * 0.0834009981938704841)));
  const Double4 odd =
      0.40000000000157244 +
      w * (0.222222239697390433 + w * (0.153865599281779019 + w * (0.121060866899222885 + w * 0.170185780516948776)));
  return f - s * (f - z * (even + z * odd));
}

[[gnu::noinline]] inline Pack log_of_any(const Pack& four) {
  Pack result;
  Eigen::Map<Eigen::Array4d>(reinterpret_cast<double*>(&result.of)) =
      Eigen::Map<const Eigen::Array4d>(reinterpret_cast<const double*>(&four.of)).log();
  return result;
}

/// Most often of determinants of F that are near one.
[[gnu::always_inline]] inline Pack log(const Pack& four) {
  if (all((four.of >= 0.5) & (four.of <= 2.))) return Pack(log_near_one(four.of));
  return log_of_any(four);
}

template <int D>
using PackVec = Eigen::Matrix<Pack, D, 1>;

template <int D>
using PackMat = Eigen::Matrix<Pack, D, D>;

/// Four particles' n numbers each, entry by entry.
template <int n>
[[gnu::always_inline]] inline void load_packs(const std::array<const double*, 4>& from, Pack* packs) {
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) packs[k + static_cast<int>(lane)].of = load4(from[lane] + k);
    transpose(packs[k].of, packs[k + 1].of, packs[k + 2].of, packs[k + 3].of);
  }
  for (; k + 2 <= n; k += 2) {
    const Double4 even = joined(load2(from[0] + k), load2(from[2] + k));
    const Double4 odd = joined(load2(from[1] + k), load2(from[3] + k));
    packs[k].of = __builtin_shufflevector(even, odd, 0, 4, 2, 6);
    packs[k + 1].of = __builtin_shufflevector(even, odd, 1, 5, 3, 7);
  }
  if (k < n) packs[k].of = Double4{from[0][k], from[1][k], from[2][k], from[3][k]};
}
template <int n>
[[gnu::always_inline]] inline void store_packs(const Pack* packs, const std::array<double*, 4>& to) {
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    Double4 rows[]{packs[k].of, packs[k + 1].of, packs[k + 2].of, packs[k + 3].of};
    transpose(rows[0], rows[1], rows[2], rows[3]);
    for (std::size_t lane = 0; lane < 4; ++lane) store4(rows[lane], to[lane] + k);
  }
  for (; k + 2 <= n; k += 2) {
    const Double4 even = __builtin_shufflevector(packs[k].of, packs[k + 1].of, 0, 4, 2, 6);
    const Double4 odd = __builtin_shufflevector(packs[k].of, packs[k + 1].of, 1, 5, 3, 7);
    store2(half(even, 0), to[0] + k), store2(half(odd, 0), to[1] + k);
    store2(half(even, 1), to[2] + k), store2(half(odd, 1), to[3] + k);
  }
  if (k < n)
    for (std::size_t lane = 0; lane < 4; ++lane) to[lane][k] = packs[k][lane];
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

/// The first `count` of the four, and zero for the others whatever they are.
template <int R, int C>
[[gnu::always_inline]] inline Eigen::Matrix<Pack, R, C> first_of(const Eigen::Matrix<Pack, R, C>& packs, int count) {
  if (count >= 4) return packs;
  const Mask4 kept{count > 0 ? -1 : 0, count > 1 ? -1 : 0, count > 2 ? -1 : 0, 0};
  return packs.unaryExpr([&kept](const Pack& four) { return Pack(Double4(Mask4(four.of) & kept)); });
}

/// Adds the sums over the four to a node, whose padding may change.
template <int C>
[[gnu::always_inline]] inline void add_sums(const Double4* q, double* node) {
  if constexpr (C == 1) {
    const Double2 halves = half(q[0], 0) + half(q[0], 1);
    *node += halves[0] + halves[1];
  } else {
    const Double4 low = sums_of_neighbours(q[0], q[1]);
    if constexpr (C == 2) {
      *reinterpret_cast<StoredDouble2*>(node) += half(low, 0) + half(low, 1);
    } else {
      const Double4 high = sums_of_neighbours(q[2], q[C - 1]);
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
