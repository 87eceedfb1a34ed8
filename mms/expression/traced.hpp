#pragma once
#include <concepts>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

/// Writes formulas down by running the code that evaluates them: a function template that is called with the number
/// type `Traced` returns its own expression.
namespace mpmvv::mms::expression {

/// X, Y, Z are reference coordinates, x, y, z current ones. The values from F on are the entries of F, row by row. They
/// occur only within derivations.
enum class Variable { X, Y, Z, x, y, z, t, F };

enum class Operation { number, variable, add, subtract, multiply, divide, power, sin, cos, tan, exp, log, sqrt, abs };

/// Thrown where expressions are compared that are not numbers: a function that branches on a value has no single
/// formula.
struct NoFormula : std::domain_error {
  using std::domain_error::domain_error;
};

/// A number that remembers the expression it comes from. Constants are folded, and products with 0 or 1 are simplified.
class Traced {
 public:
  Traced() : Traced(0.0) {}
  Traced(double number);
  template <std::integral N>
  Traced(N number) : Traced(static_cast<double>(number)) {}
  Traced(Variable variable);

  Operation operation() const;
  double number() const;          ///< value of a `number`; exponent of a `power`, a whole number above 1
  Variable variable() const;      ///< which one a `variable` is
  const Traced& operand() const;  ///< argument of a function, base of a power, left one of two
  const Traced& right() const;    ///< the right one of add, subtract, multiply and divide
  bool is_number() const { return operation() == Operation::number; }
  bool is(double value) const { return is_number() && number() == value; }
  std::size_t hash() const;

  bool same_as(const Traced& other) const;  ///< whether both are the same tree of operations
  bool contains(Variable variable) const;

  /// Return a function of an operand and a power of a base, simplified.
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

// Compare numbers. Throw NoFormula where either is not a number.
bool operator<(const Traced& a, const Traced& b);
bool operator>(const Traced& a, const Traced& b);
bool operator<=(const Traced& a, const Traced& b);
bool operator>=(const Traced& a, const Traced& b);
bool operator==(const Traced& a, const Traced& b);

using Vector = std::vector<Traced>;
using Tensor = std::vector<Vector>;  ///< by rows

/// Returns the expression with `value` in the place of the variable.
Traced substitute(const Traced& expression, Variable variable, const Traced& value);

/// Returns ∂expression/∂variable.
Traced derivative(const Traced& expression, Variable variable);

}  // namespace mpmvv::mms::expression
