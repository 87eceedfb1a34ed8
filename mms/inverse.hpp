#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "mms/elasticity.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// A motion of the unit square in plane strain that is defined by its inverse, the reference position X of the particle
/// at x,
///   X_d = x_d - w_d,   w_d = A sin πx_d T,   T = sin²(Cπt/2),   C² = E/ρ₀,
/// so that b is an expression of the current position x and the time, for codes that evaluate b there. The motion
/// starts at rest from the undeformed body. The normal displacement is zero on the walls, and nothing is sheared along
/// them. Along an axis, with g = ∂X/∂x = 1 - πA cos πx T, and w' and ẇ for the derivatives of w in x and t:
///   v = ẇ/g,   a = ẅ/g + 2 ẇ ẇ'/g² + ẇ² w''/g³,   F = 1/g
///   P = (λK + μ (F² - 1)) / F,   K = ln Π F_d
///   ρ₀ b = ρ₀ a - (λ (1 - K) g² + μ (1 + g²)) w''/g³
/// a is Dv/Dt = ∂v/∂t + v ∂v/∂x, and ∂F/∂X = w''/g³.
class SquareInverse final : public ManufacturedSolution<2> {
 public:
  SquareInverse(double amplitude, const Elasticity& material);

  Vec<2> u(const Vec<2>& X, double t) const override;
  Vec<2> v(const Vec<2>& X, double t) const override;
  Vec<2> a(const Vec<2>& X, double t) const override;
  Mat<2> F(const Vec<2>& X, double t) const override;
  Mat<2> P(const Vec<2>& X, double t) const override;
  Vec<2> b(const Vec<2>& X, double t) const override;

  double displacement_scale() const override { return std::abs(A_); }
  Vec<2> reference_point(const Vec<2>& x, double t) const override;
  expression::Formulas formulas() const override;

  Vec<2> place(const Vec<2>& X, double t) const;  ///< the position x of the particle from X
  Vec<2> b_at(const Vec<2>& x, double t) const;   ///< b at a current position

 private:
  /// The derivatives of w of an axis at a current position. N, here and below, is any scalar type.
  template <class N>
  struct Wave {
    N w_t, w_tt, w_x, w_xx, w_xt;
    N g() const { return 1 - w_x; }
    N acceleration() const;
  };
  template <class N>
  using Waves = std::array<Wave<N>, 2>;

  template <class N>
  Waves<N> waves(const std::array<N, 2>& x, const N& t) const;
  template <class N>
  std::array<N, 2> b_of(const Waves<N>& at) const;
  template <class N>
  N T(const N& t) const;
  Waves<double> waves_at(const Vec<2>& x, double t) const { return waves(std::array{x[0], x[1]}, t); }

  double A_, lambda_, mu_, rho_, C_pi_;
};

/// The displacement alone, for any scalar type, with x from 40 steps of Newton's method. Where T carries derivatives,
/// the last two steps bring those of first and second order to those of the root.
struct SquareInverseDisplacement {
  double amplitude, wave_speed;

  template <class T>
  std::array<T, 2> operator()(const std::array<T, 2>& X, const T& t) const {
    using std::cos, std::sin, std::numbers::pi;
    const T half = sin(wave_speed * pi / 2 * t), course = half * half;
    std::array<T, 2> u;
    for (std::size_t d = 0; d < 2; ++d) {
      T x = X[d];
      for (int k = 0; k < 40; ++k)
        x -= (x - amplitude * sin(pi * x) * course - X[d]) / (1 - pi * amplitude * cos(pi * x) * course);
      u[d] = x - X[d];
    }
    return u;
  }
};

}  // namespace mpmvv::mms
