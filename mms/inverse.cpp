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

template <class N>
N SquareInverse::T(const N& t) const {
  using std::sin;
  const N half = sin(C_pi_ * t / 2);
  return half * half;
}

template <class N>
N SquareInverse::Wave<N>::acceleration() const {
  const N v = w_t / g();
  return (w_tt + 2 * v * w_xt + v * v * w_xx) / g();
}

template <class N>
SquareInverse::Waves<N> SquareInverse::waves(const std::array<N, 2>& x, const N& t) const {
  using std::cos, std::sin;
  const N now = T(t), rate = C_pi_ / 2 * sin(C_pi_ * t), growth = C_pi_ * C_pi_ / 2 * cos(C_pi_ * t);
  const auto along = [&](const N& place) {
    const N sine = A_ * sin(pi * place), cosine = A_ * pi * cos(pi * place);
    return Wave<N>{sine * rate, sine * growth, cosine * now, -pi * pi * sine * now, cosine * rate};
  };
  return {along(x[0]), along(x[1])};
}

template <class N>
std::array<N, 2> SquareInverse::b_of(const Waves<N>& at) const {
  using std::log;
  const N K = -log(at[0].g() * at[1].g());
  std::array<N, 2> b{at[0].acceleration(), at[1].acceleration()};
  for (std::size_t d = 0; d < 2; ++d) {
    const N g = at[d].g(), stiffness = lambda_ * (1 - K) * g * g + mu_ * (1 + g * g);
    b[d] -= stiffness * at[d].w_xx / (g * g * g) / rho_;
  }
  return b;
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
  const auto [first, second] = waves_at(place(X, t), t);
  return {first.w_t / first.g(), second.w_t / second.g()};
}

Vec<2> SquareInverse::a(const Vec<2>& X, double t) const {
  const auto [first, second] = waves_at(place(X, t), t);
  return {first.acceleration(), second.acceleration()};
}

Mat<2> SquareInverse::F(const Vec<2>& X, double t) const {
  const auto [first, second] = waves_at(place(X, t), t);
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
  const auto [along_x, along_y] = b_of(waves_at(x, t));
  return {along_x, along_y};
}

expression::Formulas SquareInverse::formulas() const {
  const auto x = expression::current_place<2>();
  const auto t = expression::time();
  expression::Vector X;
  for (const auto& coordinate : x) X.push_back(coordinate - A_ * T(t) * sin(pi * coordinate));
  return {.inverse = expression::inverse_motion(X, expression::vector(b_of(waves(x, t))))};
}

}  // namespace mpmvv::mms
