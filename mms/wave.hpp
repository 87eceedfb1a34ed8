#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "mms/elasticity.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// A standing wave along x in the unit square that starts undeformed and needs no body force. For small-strain
/// elasticity, P = λ tr ε I + 2G ε,
///   u_x = A sin πX sin ωt,   ω = π c,   ρ₀ c² = λ + 2G,   b = 0.
/// A law of finite strain has ∂P/∂F = (λ + 2G)(1 - 2βε) along x. This excites the second harmonic q sin 2πX in
/// resonance, to leading order
///   q'' + 4ω² q = β A² π³ c² (1 - cos 2ωt)/2,   q = β A² π/8 (1 - cos 2ωt - π c t sin 2ωt).
/// At whole multiples of 1/c this q is zero, and the difference is of the third order in A (`nonlinear_error`). For
/// S (46), where P = (λ ln F + μ(F² - 1))/F, 2β = (3λ + 2G)/(λ + 2G). The order of a code with such a law cannot be
/// told from errors near this difference.
class Wave final : public ManufacturedSolution<2> {
 public:
  Wave(double amplitude, const Elasticity& material)
      : A_(amplitude),
        lambda_(material.lambda()),
        mu_(material.mu()),
        c_(std::sqrt((lambda_ + 2 * mu_) / material.density)) {}

  Vec<2> u(const Vec<2>& X, double t) const override { return along_x(A_ * sine(X) * std::sin(omega() * t)); }
  Vec<2> v(const Vec<2>& X, double t) const override { return along_x(A_ * omega() * sine(X) * std::cos(omega() * t)); }
  Vec<2> a(const Vec<2>& X, double t) const override { return -omega() * omega() * u(X, t); }
  Mat<2> F(const Vec<2>& X, double t) const override {
    Mat<2> F = Mat<2>::Identity();
    F(0, 0) += strain(X, t);
    return F;
  }
  Mat<2> P(const Vec<2>& X, double t) const override {
    return Vec<2>(lambda_ + 2 * mu_, lambda_).asDiagonal() * strain(X, t) * Mat<2>::Identity();
  }
  Vec<2> b(const Vec<2>&, double) const override { return Vec<2>::Zero(); }

  double displacement_scale() const override { return std::abs(A_); }
  expression::Formulas formulas() const override;

  /// Returns a bound of the distance, RMS over the body, m, between this wave and the motion of a neo-Hookean body,
  /// S (46), at time t. The first term is |q|. The second bounds the third order by 4 |A| (q_max/A)², where q_max is
  /// what q can have grown to. Compared with a solution in 16 harmonics, the bound was no less than the difference from
  /// ν = -0.3 to 0.49, up to A = 0.03 and ct = 6.
  double nonlinear_error(double t) const {
    using std::numbers::pi;
    const double beta = (3 * lambda_ + 2 * mu_) / (2 * (lambda_ + 2 * mu_)), phase = 2 * omega() * t;
    const double q = beta * A_ * A_ * pi / 8 * (1 - std::cos(phase) - pi * c_ * t * std::sin(phase));
    const double strain = beta * A_ * (pi / 4 + pi * pi * c_ * t / 8);
    return (std::abs(q) + 4 * strain * strain * std::abs(A_)) / std::numbers::sqrt2;
  }

 private:
  double omega() const { return std::numbers::pi * c_; }
  static double sine(const Vec<2>& X) { return std::sin(std::numbers::pi * X[0]); }
  double strain(const Vec<2>& X, double t) const {
    return A_ * std::numbers::pi * std::cos(std::numbers::pi * X[0]) * std::sin(omega() * t);
  }
  static Vec<2> along_x(double component) { return {component, 0}; }

  double A_, lambda_, mu_, c_;
};

/// The displacement alone, for any scalar type.
struct WaveDisplacement {
  double amplitude, wave_speed;

  template <class T>
  std::array<T, 2> operator()(const std::array<T, 2>& X, const T& t) const {
    using std::sin, std::numbers::pi;
    return {amplitude * sin(pi * X[0]) * sin(wave_speed * pi * t), 0.0 * t};
  }
};

inline expression::Formulas Wave::formulas() const {
  return {.reference =
              expression::motion(expression::displacement<2>(WaveDisplacement{A_, c_}), expression::nothing(2))};
}

}  // namespace mpmvv::mms
