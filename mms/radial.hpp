#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "mms/elasticity.hpp"
#include "mms/radial_profile.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// Radial motion of an annulus (D = 2, plane strain) or a spherical shell (D = 3), W §5.2, c² = E/ρ₀:
///   u = T w e_R,   T = A cos cπt,   w = c3 R³ + c2 R² + c1 R                          W (60) to (62)
///   F_RR = 1 + T w',   F_θθ = 1 + T w/R;                                              the shell's F_φφ is F_θθ
///   P_RR = (λK + μ (F_RR² - 1)) / F_RR,   P_θθ alike,   K = ln F_RR F_θθ^(D-1)        W (54)
///   Div P = dP_RR/dR + (D - 1) (P_RR - P_θθ) / R, and with F_RR - F_θθ = R dF_θθ/dR
///   b = -T/ρ₀ {π²E w + w'' [μ + M / F_RR²] + (D - 1) (w/R)' [μ + M / (F_RR F_θθ)]},   M = μ + λ (1 - K)
/// Both surfaces move. F_RR = 1 on them, so that they carry the normal stress λK, which is zero at ν = 0.
template <int D>
class Radial : public ManufacturedSolution<D> {
 public:
  Radial(double amplitude, const Radii& radii, const Elasticity& material);

  Vec<D> u(const Vec<D>& X, double t) const final;
  Vec<D> v(const Vec<D>& X, double t) const final;
  Vec<D> a(const Vec<D>& X, double t) const final;
  Mat<D> F(const Vec<D>& X, double t) const final;
  Mat<D> P(const Vec<D>& X, double t) const final;
  Vec<D> b(const Vec<D>& X, double t) const final;

  double displacement_scale() const final { return std::abs(A_) * profile_.largest(); }

  /// Evaluates body forces in lanes. Each costs one root, one division and, where λ is not zero, one logarithm.
  std::unique_ptr<PointwiseSolution<D>> at_points(const std::vector<Vec<D>>& X) const final;

  expression::Formulas formulas() const final;

  /// Also takes positions outside the body, as far as the motion is invertible there. Throws std::domain_error beyond.
  Vec<D> reference_point(const Vec<D>& x, double t) const final;

 private:
  class AtPoints;
  struct Stretches {
    double F_RR, F_tt;
  };

  double T(double t) const { return A_ * std::cos(c_pi_ * t); }
  Stretches stretches(double R, double t) const;
  template <class N>
  static N J(const N& F_RR, const N& F_tt);  ///< det F, for any scalar type
  template <class N, class S>
  N b_over_R(const N& R2, const S& T) const;  ///< b/R where R² is R2 and T(t) is T, for any scalar types

  double A_;
  RadialProfile profile_;
  double lambda_, mu_, rho_, c_pi_;
};

extern template class Radial<2>;
extern template class Radial<3>;

/// The displacement W (62) alone, for any scalar type.
template <std::size_t D>
struct RadialDisplacement {
  double amplitude;
  RadialProfile profile;
  double wave_speed;

  template <class T>
  std::array<T, D> operator()(const std::array<T, D>& X, const T& t) const {
    using std::cos, std::sqrt, std::numbers::pi;
    T R2 = X[0] * X[0];
    for (std::size_t d = 1; d < D; ++d) R2 += X[d] * X[d];
    const T over_R = amplitude * cos(wave_speed * pi * t) * profile.over_R(T(sqrt(R2)));
    std::array<T, D> u = X;
    for (T& component : u) component *= over_R;
    return u;
  }
};

}  // namespace mpmvv::mms
