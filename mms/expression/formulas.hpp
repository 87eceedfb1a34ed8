#pragma once
#include <array>
#include <functional>
#include <optional>

#include "mms/expression/traced.hpp"

namespace mpmvv::mms::expression {

/// Displacement, velocity, deformation gradient and body force of a solution as expressions of position and time.
struct Fields {
  Vector u = {}, v = {}, b = {};
  Tensor F = {};
};

/// Of X and t, of x and t, or neither: where there is a formula that is closed.
struct Formulas {
  std::optional<Fields> reference = {}, inverse = {};
};

/// The coordinates as they are.
template <std::size_t D>
std::array<Traced, D> reference_place() {
  std::array<Traced, D> X;
  for (std::size_t d = 0; d < D; ++d) X[d] = static_cast<Variable>(d);
  return X;
}
template <std::size_t D>
std::array<Traced, D> current_place() {
  std::array<Traced, D> x;
  for (std::size_t d = 0; d < D; ++d) x[d] = static_cast<Variable>(static_cast<std::size_t>(Variable::x) + d);
  return x;
}
inline Traced time() {
  return Variable::t;
}

template <std::size_t D>
Vector vector(const std::array<Traced, D>& components) {
  return {components.begin(), components.end()};
}

/// From u(X, t): v = ∂u/∂t, F = I + ∂u/∂X.
Fields motion(const Vector& u, const Vector& b);

/// From X(x, t): u = x - X, F the inverse of ∂X/∂x, v = -F ∂X/∂t.
Fields inverse_motion(const Vector& X, const Vector& b);

/// From u(X, t) and an energy W(F): b = a - Div P/ρ₀ with P = ∂W/∂F, too.
Fields motion(const Vector& u, const std::function<Traced(const Tensor& F)>& energy, double density);

/// Of a displacement functor at X and t, for any scalar type.
template <std::size_t D>
Vector displacement(const auto& functor) {
  return vector<D>(functor(reference_place<D>(), time()));
}

inline Vector nothing(std::size_t dimension) {
  return Vector(dimension, 0);
}

}  // namespace mpmvv::mms::expression
