#include "mms/inverse.hpp"

#include <boost/math/tools/roots.hpp>

namespace mpmvv::mms {

using std::numbers::pi;

SquareInverse::SquareInverse(double amplitude, const Elasticity& material)
    : A_(amplitude),
      lambda_(material.lambda()),
      mu_(material.mu()),
      rho_(material.density),
      C_pi_(std::sqrt(material.youngs_modulus / material.density) * pi) {}

double SquareInverse::T(double t) const {
  const double half = std::sin(C_pi_ * t / 2);
  return half * half;
}

std::array<SquareInverse::Wave, 2> SquareInverse::waves(const Vec<2>& x, double t) const {
  const double now = T(t), rate = C_pi_ / 2 * std::sin(C_pi_ * t), growth = C_pi_ * C_pi_ / 2 * std::cos(C_pi_ * t);
  const auto along = [&](double place) {
    const double sine = A_ * std::sin(pi * place), cosine = A_ * pi * std::cos(pi * place);
    return Wave{sine * rate, sine * growth, cosine * now, -pi * pi * sine * now, cosine * rate};
  };
  return {along(x[0]), along(x[1])};
}

Vec<2> SquareInverse::place(const Vec<2>& X, double t) const {
  const double A_T = A_ * T(t);
  const auto along = [A_T](double from) {
    const auto equation = [&](double x) {
      return std::pair(x - A_T * std::sin(pi * x) - from, 1 - pi * A_T * std::cos(pi * x));
    };
    const double reach = std::abs(A_T) + 1e-6;
    return boost::math::tools::newton_raphson_iterate(equation, from, from - reach, from + reach, 52);
  };
  return {along(X[0]), along(X[1])};
}

Vec<2> SquareInverse::reference_point(const Vec<2>& x, double t) const {
  return x.array() - A_ * T(t) * (pi * x).array().sin();
}

Vec<2> SquareInverse::u(const Vec<2>& X, double t) const {
  const Vec<2> x = place(X, t);
  return A_ * T(t) * (pi * x).array().sin();
}

Vec<2> SquareInverse::v(const Vec<2>& X, double t) const {
  const auto [first, second] = waves(place(X, t), t);
  return {first.w_t / first.g(), second.w_t / second.g()};
}

Vec<2> SquareInverse::acceleration(const std::array<Wave, 2>& at) const {
  const auto along = [](const Wave& w) {
    const double v = w.w_t / w.g();
    return (w.w_tt + 2 * v * w.w_xt + v * v * w.w_xx) / w.g();
  };
  return {along(at[0]), along(at[1])};
}

Vec<2> SquareInverse::a(const Vec<2>& X, double t) const {
  return acceleration(waves(place(X, t), t));
}

Mat<2> SquareInverse::F(const Vec<2>& X, double t) const {
  const auto [first, second] = waves(place(X, t), t);
  return Vec<2>(1 / first.g(), 1 / second.g()).asDiagonal();
}

Mat<2> SquareInverse::P(const Vec<2>& X, double t) const {
  const Vec<2> stretch = F(X, t).diagonal();
  const double K = std::log(stretch.prod());
  return Vec<2>((lambda_ * K + mu_ * (stretch.array().square() - 1)) / stretch.array()).asDiagonal();
}

Vec<2> SquareInverse::b(const Vec<2>& X, double t) const {
  return b_at(place(X, t), t);
}

Vec<2> SquareInverse::b_at(const Vec<2>& x, double t) const {
  const auto at = waves(x, t);
  const double K = -std::log(at[0].g() * at[1].g());
  Vec<2> b = acceleration(at);
  for (std::size_t d = 0; d < 2; ++d) {
    const double g = at[d].g(), stiffness = lambda_ * (1 - K) * g * g + mu_ * (1 + g * g);
    b.data()[d] -= stiffness * at[d].w_xx / (g * g * g) / rho_;
  }
  return b;
}

}  // namespace mpmvv::mms
