#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>

#include "solver/simd/double4.hpp"

namespace mpmvv::solver {

/// One number for each of four particles. It is a scalar type for Eigen: a vector or matrix of packs holds the vectors
/// or matrices of four particles.
struct Pack {
  Double4 of;

  Pack() = default;
  [[gnu::always_inline]] Pack(double same) : of{same, same, same, same} {}
  [[gnu::always_inline]] explicit Pack(const Double4& four) : of(four) {}

  double operator[](std::size_t lane) const { return of[lane]; }

  [[gnu::always_inline]] friend Pack operator+(const Pack& a, const Pack& b) { return Pack(Double4(a.of + b.of)); }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a, const Pack& b) { return Pack(Double4(a.of - b.of)); }
  [[gnu::always_inline]] friend Pack operator*(const Pack& a, const Pack& b) { return Pack(Double4(a.of * b.of)); }
  [[gnu::always_inline]] friend Pack operator/(const Pack& a, const Pack& b) { return Pack(Double4(a.of / b.of)); }
  [[gnu::always_inline]] friend Pack operator-(const Pack& a) { return Pack(Double4(-a.of)); }
  [[gnu::always_inline]] Pack& operator+=(const Pack& b) { return of += b.of, *this; }
  [[gnu::always_inline]] Pack& operator-=(const Pack& b) { return of -= b.of, *this; }
  [[gnu::always_inline]] Pack& operator*=(const Pack& b) { return of *= b.of, *this; }
};

/// Whether all four entries are true.
[[gnu::always_inline]] inline bool all(const Mask4& mask) {
  return (mask[0] & mask[1] & mask[2] & mask[3]) != 0;
}

/// Whether at least one of the four entries is true.
inline bool any(const Mask4& mask) {
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

/// Returns the greatest number below a whole number n > 0. n - n ε/2 rounds to it, ε being the distance of 1 to the
/// next number. std::nextafter would be a call for each block of particles.
inline double next_below(double n) {
  return n * (1 - std::numeric_limits<double>::epsilon() / 2);
}

/// Returns the four numbers, each moved into [least, most], a NaN to `least`. Sets `strays` to true for the numbers
/// that had to be moved, and leaves its other entries as they are.
[[gnu::always_inline]] inline Pack confined(const Pack& four, double least, double most, Mask4& strays) {
  const Double4 low = Pack(least).of, high = Pack(most).of;
  const Double4 raised = four.of > low ? four.of : low;
  const Double4 inside = raised < high ? raised : high;
  strays |= inside != four.of;
  return Pack(inside);
}

/// Returns ln x for four x in [1/2, 2]. With f = x - 1 and s = f/(2 + f), ln x = 2 artanh s = f - s (f - R), where R =
/// 2 (artanh s - s)/s. R is computed as s² times a polynomial in s², the one nearest to R/s² for s² in [0, 1/9]. The
/// polynomial's error is about 2^-58 of ln x, and rounding adds about 2^-52.
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

/// Returns ln x for four x. Determinants of F are most often near one, where the polynomial is enough.
[[gnu::always_inline]] inline Pack log(const Pack& four) {
  if (all((four.of >= 0.5) & (four.of <= 2.))) return Pack(log_near_one(four.of));
  return log_of_any(four);
}

template <int D>
using PackVec = Eigen::Matrix<Pack, D, 1>;

template <int D>
using PackMat = Eigen::Matrix<Pack, D, D>;

/// Loads the n numbers of each of four particles: packs[k] holds the k-th number of all four.
template <int n>
[[gnu::always_inline]] inline void load_packs(const std::array<const double*, 4>& from, Pack* packs) {
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) packs[k + static_cast<int>(lane)].of = load4(from[lane] + k);
    transpose(packs[k].of, packs[k + 1].of, packs[k + 2].of, packs[k + 3].of);
  }
  for (; k < n; ++k) packs[k].of = Double4{from[0][k], from[1][k], from[2][k], from[3][k]};
}
/// Stores n packs for four particles: the inverse of `load_packs`.
template <int n>
[[gnu::always_inline]] inline void store_packs(const Pack* packs, const std::array<double*, 4>& to) {
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    Double4 rows[]{packs[k].of, packs[k + 1].of, packs[k + 2].of, packs[k + 3].of};
    transpose(rows[0], rows[1], rows[2], rows[3]);
    for (std::size_t lane = 0; lane < 4; ++lane) store4(rows[lane], to[lane] + k);
  }
  for (; k < n; ++k)
    for (std::size_t lane = 0; lane < 4; ++lane) to[lane][k] = packs[k][lane];
}

}  // namespace mpmvv::solver

template <>
struct Eigen::NumTraits<mpmvv::solver::Pack> : Eigen::NumTraits<double> {
  using Real = mpmvv::solver::Pack;
  using NonInteger = Real;
  using Nested = Real;
};

template <class Op>
struct Eigen::ScalarBinaryOpTraits<double, mpmvv::solver::Pack, Op> {
  using ReturnType = mpmvv::solver::Pack;
};
template <class Op>
struct Eigen::ScalarBinaryOpTraits<mpmvv::solver::Pack, double, Op> {
  using ReturnType = mpmvv::solver::Pack;
};
