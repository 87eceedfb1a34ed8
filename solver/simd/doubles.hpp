#pragma once
#include <type_traits>
#include <utility>

#include "solver/simd/double4.hpp"

namespace mpmvv::solver {

/// n numbers, n even, in vector registers of four numbers, with one register of two numbers at the end where n is not a
/// multiple of four. They hold the components of neighbouring nodes, which lie side by side in memory. Two uses of the
/// registers of eight numbers that AVX-512 has were tried, and neither was faster:
/// - Eight numbers at once take fewer instructions, but whole cases took 0.97 to 1.09 times as long: a read from nodes
///   then overlaps only a part of what was written to them shortly before, and has to wait.
/// - p and f of each node, or v and a, side by side in one register, so that reads match writes: the loops over nodes
///   in three dimensions have 0.7 times as many products and sums, but took 0.98 to 1.09 times as long, and the loops
///   over particles alone, whose code is the same, 1.05 times.
template <int n>
struct Doubles {
  static_assert(n > 0 && n % 2 == 0);
  using Front = std::conditional_t<(n >= 4), Double4, Double2>;
  static constexpr int in_front = sizeof(Front) / sizeof(double);
  using Rest = Doubles<n - in_front>;

  Front front;
  Rest rest;

  [[gnu::always_inline]] static Doubles load(const double* from) {
    using Stored [[gnu::vector_size(sizeof(Front)), gnu::aligned(8)]] = double;
    return {*reinterpret_cast<const Stored*>(from), Rest::load(from + in_front)};
  }
  [[gnu::always_inline]] void store(double* to) const {
    using Stored [[gnu::vector_size(sizeof(Front)), gnu::aligned(8)]] = double;
    *reinterpret_cast<Stored*>(to) = front;
    rest.store(to + in_front);
  }

  /// Returns the n numbers of(first), of(first + 1), ...
  template <int first = 0, class Of>
  [[gnu::always_inline]] static Doubles each(const Of& of) {
    const auto front_of = [&of]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
      return Front{of(first + k)...};
    };
    return {front_of(std::make_integer_sequence<int, in_front>{}), Rest::template each<first + in_front>(of)};
  }

  [[gnu::always_inline]] friend Doubles operator*(double c, const Doubles& a) { return {c * a.front, c * a.rest}; }
  [[gnu::always_inline]] friend Doubles operator*(const Doubles& a, const Doubles& b) {
    return {a.front * b.front, a.rest * b.rest};
  }
  [[gnu::always_inline]] Doubles& operator+=(const Doubles& b) {
    front += b.front;
    rest += b.rest;
    return *this;
  }
};

template <>
struct Doubles<0> {
  [[gnu::always_inline]] static Doubles load(const double*) { return {}; }
  [[gnu::always_inline]] void store(double*) const {}
  template <int first, class Of>
  [[gnu::always_inline]] static Doubles each(const Of&) {
    return {};
  }
  [[gnu::always_inline]] friend Doubles operator*(double, const Doubles&) { return {}; }
  [[gnu::always_inline]] friend Doubles operator*(const Doubles&, const Doubles&) { return {}; }
  [[gnu::always_inline]] Doubles& operator+=(const Doubles&) { return *this; }
};

/// Returns the last two numbers, where n is not a multiple of four.
template <int n>
[[gnu::always_inline]] inline Double2 last_of(const Doubles<n>& all) {
  if constexpr (n == 2)
    return all.front;
  else
    return last_of(all.rest);
}

/// Returns sum + Σ a b over the registers of a and b that are as wide as `sum`; a narrower last register is left out.
template <class Register, int n>
[[gnu::always_inline]] inline Register add_products(const Register& sum, const Doubles<n>& a, const Doubles<n>& b) {
  if constexpr (n * sizeof(double) >= sizeof(Register))
    return add_products(Register(sum + a.front * b.front), a.rest, b.rest);
  else
    return sum;
}

/// Returns Σ a b over the nodes, for each of the C components that a node has side by side.
template <int C, int n>
[[gnu::always_inline]] inline auto sum_of_products(const Doubles<n>& a, const Doubles<n>& b) {
  const auto sum = add_products(a.front * b.front, a.rest, b.rest);
  if constexpr (C == Doubles<n>::in_front)
    return sum;
  else if constexpr (n % Doubles<n>::in_front == 0)
    return half(sum, 0) + half(sum, 1);
  else
    return half(sum, 0) + half(sum, 1) + last_of(a) * last_of(b);
}

}  // namespace mpmvv::solver
