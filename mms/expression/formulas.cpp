#include "mms/expression/formulas.hpp"

namespace mpmvv::mms::expression {

namespace {

Variable reference(std::size_t d) {
  return static_cast<Variable>(d);
}
Variable current(std::size_t d) {
  return static_cast<Variable>(static_cast<std::size_t>(Variable::x) + d);
}

/// Returns the matrix without row i and column j.
Tensor minor_of(const Tensor& matrix, std::size_t i, std::size_t j) {
  Tensor minor;
  for (std::size_t row = 0; row < matrix.size(); ++row) {
    if (row == i) continue;
    minor.emplace_back();
    for (std::size_t column = 0; column < matrix.size(); ++column)
      if (column != j) minor.back().push_back(matrix[row][column]);
  }
  return minor;
}

/// Uses Laplace's formula along the first row.
Traced determinant(const Tensor& matrix) {
  if (matrix.empty()) return 1;
  Traced sum = 0;
  for (std::size_t j = 0; j < matrix.size(); ++j)
    sum += (j % 2 == 0 ? 1 : -1) * matrix[0][j] * determinant(minor_of(matrix, 0, j));
  return sum;
}

/// Uses Cramer's rule.
Tensor inverse(const Tensor& matrix) {
  const Traced whole = determinant(matrix);
  Tensor result(matrix.size(), Vector(matrix.size()));
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j)
      result[i][j] = ((i + j) % 2 == 0 ? 1 : -1) * determinant(minor_of(matrix, j, i)) / whole;
  return result;
}

/// Returns the variable that stands for the entry F_iJ.
Variable entry(std::size_t i, std::size_t J) {
  return static_cast<Variable>(static_cast<std::size_t>(Variable::F) + 3 * i + J);
}

Tensor entries(std::size_t n) {
  Tensor F(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t J = 0; J < n; ++J) F[i].emplace_back(entry(i, J));
  return F;
}

/// Returns an expression of the entries of F with the entries of this F in their places.
Traced with_entries(Traced expression, const Tensor& F) {
  for (std::size_t i = 0; i < F.size(); ++i)
    for (std::size_t J = 0; J < F.size(); ++J) expression = substitute(expression, entry(i, J), F[i][J]);
  return expression;
}

}  // namespace

Fields motion(const Vector& u, const Vector& b) {
  Fields fields{.u = u, .b = b};
  for (std::size_t i = 0; i < u.size(); ++i) {
    fields.v.push_back(derivative(u[i], Variable::t));
    fields.F.emplace_back();
    for (std::size_t J = 0; J < u.size(); ++J)
      fields.F.back().push_back((i == J ? 1 : 0) + derivative(u[i], reference(J)));
  }
  return fields;
}

/// Uses Div P_i = Σ ∂P_iJ/∂F_kL ∂F_kL/∂X_J.
Fields motion(const Vector& u, const std::function<Traced(const Tensor&)>& energy, double density) {
  const std::size_t n = u.size();
  Fields fields = motion(u, {});
  const Traced W = energy(entries(n));
  for (std::size_t i = 0; i < n; ++i) {
    Traced divergence = 0;
    for (std::size_t J = 0; J < n; ++J)
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t L = 0; L < n; ++L) {
          const Traced slope = derivative(fields.F[k][L], reference(J));
          if (slope.is(0)) continue;
          divergence += with_entries(derivative(derivative(W, entry(i, J)), entry(k, L)), fields.F) * slope;
        }
    fields.b.push_back(derivative(fields.v[i], Variable::t) - divergence / density);
  }
  return fields;
}

Fields inverse_motion(const Vector& X, const Vector& b) {
  const std::size_t n = X.size();
  Fields fields{.b = b};
  Tensor gradient(n);  // ∂X/∂x
  for (std::size_t i = 0; i < n; ++i) {
    fields.u.push_back(current(i) - X[i]);
    for (std::size_t j = 0; j < n; ++j) gradient[i].push_back(derivative(X[i], current(j)));
  }
  fields.F = inverse(gradient);
  for (std::size_t i = 0; i < n; ++i) {
    Traced v = 0;
    for (std::size_t j = 0; j < n; ++j) v -= fields.F[i][j] * derivative(X[j], Variable::t);
    fields.v.push_back(v);
  }
  return fields;
}

}  // namespace mpmvv::mms::expression
