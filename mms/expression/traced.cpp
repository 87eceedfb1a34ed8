#include "mms/expression/traced.hpp"

#include <cmath>
#include <functional>
#include <limits>

namespace mpmvv::mms::expression {

struct Traced::Node {
  Operation operation;
  double number = 0;
  Variable variable = Variable::t;
  std::vector<Traced> operands = {};
  std::size_t hash = 0;
};

namespace {

std::size_t mixed(std::size_t seed, std::size_t more) {
  return seed ^ (more + 0x9e3779b97f4a7c15 + (seed << 6) + (seed >> 2));
}

double value_of(Operation function, double x) {
  switch (function) {
    case Operation::sin:
      return std::sin(x);
    case Operation::cos:
      return std::cos(x);
    case Operation::tan:
      return std::tan(x);
    case Operation::exp:
      return std::exp(x);
    case Operation::log:
      return std::log(x);
    case Operation::sqrt:
      return std::sqrt(x);
    case Operation::abs:
      return std::abs(x);
    default:
      throw std::logic_error("no function of one operand");
  }
}

/// Whether this is a sine or cosine that would be zero, if its argument, a multiple of π/2, were not rounded.
bool is_rounded_zero(Operation function, double x, double value) {
  const bool is_wave = function == Operation::sin || function == Operation::cos;
  return is_wave && std::abs(value) <= std::numeric_limits<double>::epsilon() * std::abs(x);
}

}  // namespace

Traced::Traced(double number) {
  const double value = number == 0 ? 0 : number;  // no -0
  node_ = std::make_shared<Node>(
      Node{.operation = Operation::number, .number = value, .hash = mixed(0, std::hash<double>{}(value))});
}

Traced::Traced(Variable variable)
    : node_(std::make_shared<Node>(Node{.operation = Operation::variable,
                                        .variable = variable,
                                        .hash = mixed(1, static_cast<std::size_t>(variable))})) {}

Operation Traced::operation() const {
  return node_->operation;
}
double Traced::number() const {
  return node_->number;
}
Variable Traced::variable() const {
  return node_->variable;
}
const Traced& Traced::operand() const {
  return node_->operands.at(0);
}
const Traced& Traced::right() const {
  return node_->operands.at(1);
}
std::size_t Traced::hash() const {
  return node_->hash;
}

bool Traced::same_as(const Traced& other) const {
  if (node_ == other.node_) return true;
  if (hash() != other.hash() || operation() != other.operation() || number() != other.number() ||
      variable() != other.variable())
    return false;
  for (std::size_t k = 0; k < node_->operands.size(); ++k)
    if (!node_->operands[k].same_as(other.node_->operands[k])) return false;
  return true;
}

bool Traced::contains(Variable sought) const {
  if (operation() == Operation::variable) return variable() == sought;
  for (const Traced& operand : node_->operands)
    if (operand.contains(sought)) return true;
  return false;
}

Traced Traced::made(Operation operation, const Traced& left, const Traced& right) {
  const std::size_t hash = mixed(mixed(static_cast<std::size_t>(operation) + 2, left.hash()), right.hash());
  return Traced(std::make_shared<Node>(Node{.operation = operation, .operands = {left, right}, .hash = hash}));
}

Traced Traced::of(Operation function, const Traced& operand) {
  if (operand.is_number()) {
    const double x = operand.number(), value = value_of(function, x);
    return is_rounded_zero(function, x, value) ? 0 : value;
  }
  const std::size_t hash = mixed(static_cast<std::size_t>(function) + 2, operand.hash());
  return Traced(std::make_shared<Node>(Node{.operation = function, .operands = {operand}, .hash = hash}));
}

Traced Traced::power(const Traced& base, int exponent) {
  if (exponent == 0) return 1;
  if (exponent == 1) return base;
  if (exponent < 0) return 1 / power(base, -exponent);
  if (base.is_number()) return std::pow(base.number(), exponent);
  if (base.operation() == Operation::power) return power(base.operand(), exponent * static_cast<int>(base.number()));
  const std::size_t hash =
      mixed(mixed(static_cast<std::size_t>(Operation::power) + 2, base.hash()), static_cast<std::size_t>(exponent));
  return Traced(std::make_shared<Node>(
      Node{.operation = Operation::power, .number = static_cast<double>(exponent), .operands = {base}, .hash = hash}));
}

Traced& Traced::operator+=(const Traced& other) {
  return *this = *this + other;
}
Traced& Traced::operator-=(const Traced& other) {
  return *this = *this - other;
}
Traced& Traced::operator*=(const Traced& other) {
  return *this = *this * other;
}
Traced& Traced::operator/=(const Traced& other) {
  return *this = *this / other;
}

}  // namespace mpmvv::mms::expression
