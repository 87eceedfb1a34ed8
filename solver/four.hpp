#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "solver/quad.hpp"
#include "solver/types.hpp"

namespace mpmvv::solver {

/// A number of each of four particles: a scalar for Eigen, whose vectors and matrices then hold four of theirs.
struct Four {
  Quad of;

  Four() = default;
  [[gnu::always_inline]] Four(double same) : of{same, same, same, same} {}
  [[gnu::always_inline]] explicit Four(const Quad& quad) : of(quad) {}

  double operator[](std::size_t lane) const { return of[lane]; }

  [[gnu::always_inline]] friend Four operator+(const Four& a, const Four& b) { return Four(Quad(a.of + b.of)); }
  [[gnu::always_inline]] friend Four operator-(const Four& a, const Four& b) { return Four(Quad(a.of - b.of)); }
  [[gnu::always_inline]] friend Four operator*(const Four& a, const Four& b) { return Four(Quad(a.of * b.of)); }
  [[gnu::always_inline]] friend Four operator-(const Four& a) { return Four(Quad(-a.of)); }
  [[gnu::always_inline]] Four& operator+=(const Four& b) { return of += b.of, *this; }
  [[gnu::always_inline]] Four& operator-=(const Four& b) { return of -= b.of, *this; }
  [[gnu::always_inline]] Four& operator*=(const Four& b) { return of *= b.of, *this; }
};

/// Whether all are true.
[[gnu::always_inline]] inline bool all(const Truths& truths) {
  return (truths[0] & truths[1] & truths[2] & truths[3]) != 0;
}

/// Whether one is true.
inline bool any(const Truths& truths) {
  return (truths[0] | truths[1] | truths[2] | truths[3]) != 0;
}

/// Each moved into [least, most], a NaN to `least`; true in `strays` for those that had to be moved.
[[gnu::always_inline]] inline Four confined(const Four& four, double least, double most, Truths& strays) {
  const Quad low = Four(least).of, high = Four(most).of;
  const Quad raised = four.of > low ? four.of : low;
  const Quad inside = raised < high ? raised : high;
  strays |= inside != four.of;
  return Four(inside);
}

/// ln x of four x in [1/2, 2]. With f = x - 1 and s = f/(2 + f) it is 2 artanh s = f - s (f - R), where R = 2 (artanh s
/// - s)/s is s² times the polynomial in s² that is nearest to it on [0, 1/9], to 2^-59 of ln x.
[[gnu::always_inline]] inline Quad log_near_one(const Quad& x) {
  const Quad f = x - 1., s = f / (f + 2.), z = s * s, w = z * z;
  const Quad even =
      0.666666666666663038 +
      w * (0.285714285478537461 + w * (0.181817439246665672 + w * (0.133009735248520771 + w * 0.0834009981938704841)));
  const Quad odd =
      0.40000000000157244 +
      w * (0.222222239697390433 + w * (0.153865599281779019 + w * (0.121060866899222885 + w * 0.170185780516948776)));
  return f - s * (f - z * (even + z * odd));
}

[[gnu::noinline]] inline Four log_of_any(const Four& four) {
  Four result;
  Eigen::Map<Eigen::Array4d>(reinterpret_cast<double*>(&result.of)) =
      Eigen::Map<const Eigen::Array4d>(reinterpret_cast<const double*>(&four.of)).log();
  return result;
}

/// Most often of determinants of F that are near one.
[[gnu::always_inline]] inline Four log(const Four& four) {
  if (all((four.of >= 0.5) & (four.of <= 2.))) return Four(log_near_one(four.of));
  return log_of_any(four);
}

template <int D>
using FourVec = Eigen::Matrix<Four, D, 1>;

template <int D>
using FourMat = Eigen::Matrix<Four, D, D>;

/// Four particles' n numbers each, entry by entry.
template <int n>
[[gnu::always_inline]] inline void load_fours(const std::array<const double*, 4>& from, Four* fours) {
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) fours[k + static_cast<int>(lane)].of = load_quad(from[lane] + k);
    transpose(fours[k].of, fours[k + 1].of, fours[k + 2].of, fours[k + 3].of);
  }
  for (; k + 2 <= n; k += 2) {
    const Quad even = joined(load_pair(from[0] + k), load_pair(from[2] + k));
    const Quad odd = joined(load_pair(from[1] + k), load_pair(from[3] + k));
    fours[k].of = __builtin_shufflevector(even, odd, 0, 4, 2, 6);
    fours[k + 1].of = __builtin_shufflevector(even, odd, 1, 5, 3, 7);
  }
  if (k < n) fours[k].of = Quad{from[0][k], from[1][k], from[2][k], from[3][k]};
}
template <int n>
[[gnu::always_inline]] inline void store_fours(const Four* fours, const std::array<double*, 4>& to) {
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    Quad rows[]{fours[k].of, fours[k + 1].of, fours[k + 2].of, fours[k + 3].of};
    transpose(rows[0], rows[1], rows[2], rows[3]);
    for (std::size_t lane = 0; lane < 4; ++lane) store_quad(rows[lane], to[lane] + k);
  }
  for (; k + 2 <= n; k += 2) {
    const Quad even = __builtin_shufflevector(fours[k].of, fours[k + 1].of, 0, 4, 2, 6);
    const Quad odd = __builtin_shufflevector(fours[k].of, fours[k + 1].of, 1, 5, 3, 7);
    store_pair(half(even, 0), to[0] + k), store_pair(half(odd, 0), to[1] + k);
    store_pair(half(even, 1), to[2] + k), store_pair(half(odd, 1), to[3] + k);
  }
  if (k < n)
    for (std::size_t lane = 0; lane < 4; ++lane) to[lane][k] = fours[k][lane];
}

/// The vectors with one more component.
template <int D>
[[gnu::always_inline]] inline FourVec<D + 1> packed(const FourVec<D>& vector, const Four& last) {
  FourVec<D + 1> longer;
  longer.template head<D>() = vector;
  longer[D] = last;
  return longer;
}

template <int D>
[[gnu::always_inline]] inline FourVec<D + 1> packed_alone(const Four& last) {
  return packed<D>(FourVec<D>(FourVec<D>::Zero()), last);
}

/// The first `count` of the four, and zero for the others whatever they are.
template <int R, int C>
[[gnu::always_inline]] inline Eigen::Matrix<Four, R, C> first_of(const Eigen::Matrix<Four, R, C>& fours, int count) {
  if (count >= 4) return fours;
  const Truths kept{count > 0 ? -1 : 0, count > 1 ? -1 : 0, count > 2 ? -1 : 0, 0};
  return fours.unaryExpr([&kept](const Four& four) { return Four(Quad(Truths(four.of) & kept)); });
}

/// Adds the sums over the four to a node, whose padding may change.
template <int C>
[[gnu::always_inline]] inline void add_sums(const Quad* q, double* node) {
  if constexpr (C == 1) {
    const Pair halves = half(q[0], 0) + half(q[0], 1);
    *node += halves[0] + halves[1];
  } else {
    const Quad low = sums_of_neighbours(q[0], q[1]);
    if constexpr (C == 2) {
      *reinterpret_cast<StoredPair*>(node) += half(low, 0) + half(low, 1);
    } else {
      const Quad high = sums_of_neighbours(q[2], q[C - 1]);
      *reinterpret_cast<StoredQuad*>(node) +=
          __builtin_shufflevector(low, high, 0, 1, 4, 5) + __builtin_shufflevector(low, high, 2, 3, 6, 7);
    }
  }
}

}  // namespace mpmvv::solver

template <>
struct Eigen::NumTraits<mpmvv::solver::Four> {
  using Real = mpmvv::solver::Four;
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
struct Eigen::ScalarBinaryOpTraits<double, mpmvv::solver::Four, Op> {
  using ReturnType = mpmvv::solver::Four;
};
template <class Op>
struct Eigen::ScalarBinaryOpTraits<mpmvv::solver::Four, double, Op> {
  using ReturnType = mpmvv::solver::Four;
};
