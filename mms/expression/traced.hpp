#pragma once
#include <concepts>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// Formulas written down by the code that evaluates them: a function template called with this type of number gives its
/// own expression.
namespace mpmvv::mms::expression {

/// X, Y, Z are reference coordinates, x, y, z current ones; from F on there are the entries of F, row by row, which
/// stand in derivations alone.
enum class Variable { X, Y, Z, x, y, z, t, F };

enum class Operation { number, variable, add, subtract, multiply, divide, power, sin, cos, tan, exp, log, sqrt, abs };

/// An expression that was never one of numbers: a function that branches on a value has no single formula.
struct NoFormula : std::domain_error {
  using std::domain_error::domain_error;
};

/// A number that remembers how it came about. Constants are folded, and what is multiplied by 0 or 1 goes.
class Traced {
 public:
  Traced() : Traced(0.0) {}
  Traced(double number);
  template <std::integral N>
  Traced(N number) : Traced(static_cast<double>(number)) {}
  Traced(Variable variable);

  Operation operation() const;
  double number() const;          ///< of a `number`; of a `power` the exponent, a whole number above 1
  Variable variable() const;      ///< of a `variable`
  const Traced& operand() const;  ///< of a function, the base of a power, the left one of two
  const Traced& right() const;    ///< of add, subtract, multiply and divide
  bool is_number() const { return operation() == Operation::number; }
  bool is(double value) const { return is_number() && number() == value; }
  std::size_t hash() const;

  bool same_as(const Traced& other) const;  ///< the same expression, word by word
  bool contains(Variable variable) const;

  /// Of an operation with these operands, simplified.
  static Traced of(Operation function, const Traced& operand);
  static Traced power(const Traced& base, int exponent);

  Traced& operator+=(const Traced& other);
  Traced& operator-=(const Traced& other);
  Traced& operator*=(const Traced& other);
  Traced& operator/=(const Traced& other);

 private:
  struct Node;
  explicit Traced(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  static Traced made(Operation operation, const Traced& left, const Traced& right);

  friend Traced operator+(const Traced& a, const Traced& b);
  friend Traced operator-(const Traced& a, const Traced& b);
  friend Traced operator*(const Traced& a, const Traced& b);
  friend Traced operator/(const Traced& a, const Traced& b);

  std::shared_ptr<const Node> node_;
};

Traced operator+(const Traced& a, const Traced& b);
Traced operator-(const Traced& a, const Traced& b);
Traced operator*(const Traced& a, const Traced& b);
Traced operator/(const Traced& a, const Traced& b);
Traced operator-(const Traced& a);
Traced operator+(const Traced& a);

Traced sin(const Traced& a);
Traced cos(const Traced& a);
Traced tan(const Traced& a);
Traced exp(const Traced& a);
Traced log(const Traced& a);
Traced sqrt(const Traced& a);
Traced abs(const Traced& a);
Traced fabs(const Traced& a);
Traced pow(const Traced& base, const Traced& exponent);

// Of numbers alone; NoFormula otherwise.
bool operator<(const Traced& a, const Traced& b);
bool operator>(const Traced& a, const Traced& b);
bool operator<=(const Traced& a, const Traced& b);
bool operator>=(const Traced& a, const Traced& b);
bool operator==(const Traced& a, const Traced& b);

using Vector = std::vector<Traced>;
using Tensor = std::vector<Vector>;  ///< by rows

/// With the variable replaced.
Traced substitute(const Traced& expression, Variable variable, const Traced& value);

/// ∂/∂variable
Traced derivative(const Traced& expression, Variable variable);

}  // namespace mpmvv::mms::expression
