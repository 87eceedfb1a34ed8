#include <cmath>

#include "mms/expression/traced.hpp"

/// The operators of `Traced`. They simplify: constants move to the front, where those of a product are combined.
namespace mpmvv::mms::expression {

namespace {

/// An expression as factor * rest, where the factor is a number.
struct Scaled {
  double factor;
  Traced rest;
};

Scaled scaled(const Traced& a) {
  if (a.is_number()) return {a.number(), 1};
  if (a.operation() == Operation::multiply && a.operand().is_number()) return {a.operand().number(), a.right()};
  return {1, a};
}

/// An expression as base and exponent; the exponent is 1 where it is not a power.
struct Powered {
  Traced base;
  int exponent;
};

Powered powered(const Traced& a) {
  if (a.operation() == Operation::power) return {a.operand(), static_cast<int>(a.number())};
  return {a, 1};
}

bool is_negative(const Traced& a) {
  return scaled(a).factor < 0;
}

}  // namespace

Traced operator+(const Traced& a, const Traced& b) {
  if (a.is_number() && b.is_number()) return a.number() + b.number();
  if (a.is(0)) return b;
  if (b.is(0)) return a;
  if (b.is_number() && !is_negative(b)) return b + a;
  if (is_negative(b)) return a - -b;
  if (is_negative(a)) return b - -a;
  if (a.operation() == Operation::subtract && a.right().same_as(b)) return a.operand();
  return Traced::made(Operation::add, a, b);
}

Traced operator-(const Traced& a, const Traced& b) {
  if (a.is_number() && b.is_number()) return a.number() - b.number();
  if (b.is(0)) return a;
  if (a.is(0)) return -b;
  if (a.same_as(b)) return 0;
  if (b.operation() == Operation::subtract && b.operand().same_as(a)) return b.right();
  if (is_negative(b)) return a + -b;
  if (a.operation() == Operation::add && a.operand().same_as(b)) return a.right();
  if (a.operation() == Operation::add && a.right().same_as(b)) return a.operand();
  return Traced::made(Operation::subtract, a, b);
}

Traced operator*(const Traced& a, const Traced& b) {
  const auto [f, x] = scaled(a);
  const auto [g, y] = scaled(b);
  const double factor = f * g;
  if (factor == 0) return 0;
  if (f != 1 || g != 1) {
    const Traced rest = x * y;
    if (rest.is(1)) return factor;
    return factor == 1 ? rest : Traced::made(Operation::multiply, factor, rest);
  }
  if (x.is(1)) return y;
  if (y.is(1)) return x;
  const auto [base, m] = powered(x);
  const auto [other, n] = powered(y);
  if (base.same_as(other)) return Traced::power(base, m + n);
  if (x.operation() == Operation::multiply && powered(x.right()).base.same_as(other))
    return x.operand() * (x.right() * y);
  return Traced::made(Operation::multiply, x, y);
}

Traced operator/(const Traced& a, const Traced& b) {
  if (b.operation() == Operation::divide) return a * b.right() / b.operand();
  const auto [f, x] = scaled(a);
  const auto [g, y] = scaled(b);
  if (f == 0 && g != 0) return 0;
  if (x.same_as(y)) return f / g;
  if (y.is(1)) return f == 1 && !x.is(1) && g != 1 ? Traced::made(Operation::divide, x, g) : f / g * x;
  if (g != 1) return f / g * (x / y);
  if (x.is(1)) return f < 0 ? -1.0 * Traced::made(Operation::divide, -f, y) : Traced::made(Operation::divide, f, y);
  return f == 1 ? Traced::made(Operation::divide, x, y) : f * (x / y);
}

Traced operator-(const Traced& a) {
  if (a.operation() == Operation::subtract) return a.right() - a.operand();
  return -1.0 * a;
}
Traced operator+(const Traced& a) {
  return a;
}

Traced sin(const Traced& a) {
  return Traced::of(Operation::sin, a);
}
Traced cos(const Traced& a) {
  return Traced::of(Operation::cos, a);
}
Traced tan(const Traced& a) {
  return Traced::of(Operation::tan, a);
}
Traced exp(const Traced& a) {
  return Traced::of(Operation::exp, a);
}
Traced log(const Traced& a) {
  return Traced::of(Operation::log, a);
}
Traced sqrt(const Traced& a) {
  return Traced::of(Operation::sqrt, a);
}
Traced abs(const Traced& a) {
  return Traced::of(Operation::abs, a);
}
Traced fabs(const Traced& a) {
  return abs(a);
}
Traced pow(const Traced& base, const Traced& exponent) {
  constexpr double most = 64;  // the largest exponent of a power; beyond it exp(exponent * log(base)) is used
  const bool is_whole =
      exponent.is_number() && std::abs(exponent.number()) <= most && std::floor(exponent.number()) == exponent.number();
  return is_whole ? Traced::power(base, static_cast<int>(exponent.number())) : exp(exponent * log(base));
}

namespace {

double compared(const Traced& a) {
  if (!a.is_number()) throw NoFormula("a function that branches on a value has no single formula");
  return a.number();
}

}  // namespace

bool operator<(const Traced& a, const Traced& b) {
  return compared(a) < compared(b);
}
bool operator>(const Traced& a, const Traced& b) {
  return b < a;
}
bool operator<=(const Traced& a, const Traced& b) {
  return compared(a) <= compared(b);
}
bool operator>=(const Traced& a, const Traced& b) {
  return b <= a;
}
bool operator==(const Traced& a, const Traced& b) {
  return compared(a) == compared(b);
}

}  // namespace mpmvv::mms::expression
