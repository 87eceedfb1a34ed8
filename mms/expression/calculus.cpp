#include "mms/expression/traced.hpp"

namespace mpmvv::mms::expression {

namespace {

/// Returns the same operation on the operands that `replaced` makes of its own.
Traced redone(const Traced& expression, const auto& replaced) {
  const auto one = [&] { return replaced(expression.operand()); };
  const auto other = [&] { return replaced(expression.right()); };
  switch (expression.operation()) {
    case Operation::number:
    case Operation::variable:
      return expression;
    case Operation::add:
      return one() + other();
    case Operation::subtract:
      return one() - other();
    case Operation::multiply:
      return one() * other();
    case Operation::divide:
      return one() / other();
    case Operation::power:
      return Traced::power(one(), static_cast<int>(expression.number()));
    default:
      return Traced::of(expression.operation(), one());
  }
}

/// Returns f' of a function f at x.
Traced slope(Operation function, const Traced& x) {
  switch (function) {
    case Operation::sin:
      return cos(x);
    case Operation::cos:
      return -sin(x);
    case Operation::tan:
      return 1 + Traced::power(tan(x), 2);
    case Operation::exp:
      return exp(x);
    case Operation::log:
      return 1 / x;
    case Operation::sqrt:
      return 0.5 / sqrt(x);
    case Operation::abs:
      return x / abs(x);
    default:
      throw std::logic_error("no function of one operand");
  }
}

}  // namespace

Traced substitute(const Traced& expression, Variable variable, const Traced& value) {
  if (expression.operation() == Operation::variable) return expression.variable() == variable ? value : expression;
  return redone(expression, [&](const Traced& operand) { return substitute(operand, variable, value); });
}

Traced derivative(const Traced& expression, Variable variable) {
  const auto d = [variable](const Traced& operand) { return derivative(operand, variable); };
  switch (expression.operation()) {
    case Operation::number:
      return 0;
    case Operation::variable:
      return expression.variable() == variable ? 1 : 0;
    case Operation::add:
      return d(expression.operand()) + d(expression.right());
    case Operation::subtract:
      return d(expression.operand()) - d(expression.right());
    case Operation::multiply:
      return d(expression.operand()) * expression.right() + expression.operand() * d(expression.right());
    case Operation::divide:
      return (d(expression.operand()) - expression * d(expression.right())) / expression.right();
    case Operation::power: {
      const int n = static_cast<int>(expression.number());
      return n * Traced::power(expression.operand(), n - 1) * d(expression.operand());
    }
    default:
      return d(expression.operand()) * slope(expression.operation(), expression.operand());
  }
}

}  // namespace mpmvv::mms::expression
