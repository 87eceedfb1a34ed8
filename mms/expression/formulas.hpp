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

/// The fields of a solution as expressions of X and t (`reference`) and of x and t (`inverse`), each where it has a
/// closed form.
struct Formulas {
  std::optional<Fields> reference = {}, inverse = {};
};

/// Return the coordinates as expressions: the variables X, Y, Z or x, y, z.
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

/// Derives v = ∂u/∂t and F = I + ∂u/∂X from u(X, t).
Fields motion(const Vector& u, const Vector& b);

/// Derives u = x - X, F as the inverse of ∂X/∂x, and v = -F ∂X/∂t from X(x, t).
Fields inverse_motion(const Vector& X, const Vector& b);

/// Derives v and F from u(X, t), and with the energy W(F) also b = a - Div P/ρ₀, P = ∂W/∂F.
Fields motion(const Vector& u, const std::function<Traced(const Tensor& F)>& energy, double density);

/// Evaluates a displacement functor, which takes any scalar type, at the variables X and t.
template <std::size_t D>
Vector displacement(const auto& functor) {
  return vector<D>(functor(reference_place<D>(), time()));
}

inline Vector nothing(std::size_t dimension) {
  return Vector(dimension, 0);
}

}  // namespace mpmvv::mms::expression
