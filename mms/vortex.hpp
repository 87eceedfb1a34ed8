#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mms/elasticity.hpp"
#include "mms/radii.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// The generalized vortex of Kamojjala, Brannon, Sadeghirad and Guilkey (2015), an annulus in plane strain: the point
/// at reference radius R turns by
///   α = G H,   G = A sin(πt/period),   H = 1 - 8s² + 16s⁴ = (1 - 4s²)²,   s = (R - (R_I + R_O)/2) / (R_O - R_I)
/// and keeps its radius. With Q the rotation by α and γ = R ∂α/∂R:
///   x = Q X,   F = Q (I + γ e_θ⊗e_R),   P = μ (F - F⁻ᵀ) = μγ Q (e_θ⊗e_R + e_R⊗e_θ)
///   b = Q {[R ∂²α/∂t² - μ/ρ₀ (3 ∂α/∂R + R ∂²α/∂R²)] e_θ - R [(∂α/∂t)² - μ/ρ₀ (∂α/∂R)²] e_R}
/// J = 1 everywhere, so λ ln J of S (46) vanishes with its derivatives, and ν acts through μ alone. H and H' vanish at
/// both radii, so the two circles stay at rest and free of traction.
class Vortex final : public ManufacturedSolution<2> {
 public:
  /// amplitude: the largest angle, rad; period: half of the period of the motion, s.
  Vortex(double amplitude, const Radii& radii, double period, const Elasticity& material);

  Vec<2> u(const Vec<2>& X, double t) const override;
  Vec<2> v(const Vec<2>& X, double t) const override;
  Vec<2> a(const Vec<2>& X, double t) const override;
  Mat<2> F(const Vec<2>& X, double t) const override;
  Mat<2> P(const Vec<2>& X, double t) const override;
  Vec<2> b(const Vec<2>& X, double t) const override;

  double displacement_scale() const override { return std::min(std::abs(A_), 2.0) * (radii_.inner + radii_.outer) / 2; }

  /// Evaluates displacements and body forces in lanes, including their sines and cosines.
  std::unique_ptr<PointwiseSolution<2>> at_points(const std::vector<Vec<2>>& X) const override;

  expression::Formulas formulas() const override;

  /// The motion keeps the radius of a point, so its inverse is the rotation by -α.
  Vec<2> reference_point(const Vec<2>& x, double t) const override;

 private:
  class AtPoints;
  template <class N>
  struct Profile {
    N H, dH, d2H;
  };

  /// Returns H and its derivatives. N, here and below, is any scalar type.
  template <class N>
  Profile<N> profile(const N& R) const;
  /// The parts of b = Q (along R e_R + across R e_θ) at a radius R, and the angle α of Q.
  template <class N>
  struct Parts {
    N along, across, alpha;
  };
  /// Returns these parts at radius R where G(t) is G and its derivative dG.
  template <class N, class S>
  Parts<N> parts(const N& R, const S& G, const S& dG) const;
  /// Returns b at X where G(t) is G and its derivative dG.
  template <class N>
  std::array<N, 2> b_at(const std::array<N, 2>& X, double G, double dG) const;
  /// Returns u at X where G(t) is G.
  template <class N>
  std::array<N, 2> displacement(const std::array<N, 2>& X, double G) const;

  double G(double t) const { return A_ * std::sin(rate_ * t); }
  double dG(double t) const { return A_ * rate_ * std::cos(rate_ * t); }

  double A_;
  Radii radii_;
  double rate_;         ///< π/period
  double mu_, mu_rho_;  ///< μ, μ/ρ₀
};

/// The displacement Q X - X alone, for any scalar type.
struct VortexDisplacement {
  double amplitude;
  Radii radii;
  double period;

  template <class T>
  std::array<T, 2> operator()(const std::array<T, 2>& X, const T& t) const {
    using std::cos, std::sin, std::sqrt, std::numbers::pi;
    const T R = sqrt(X[0] * X[0] + X[1] * X[1]);
    const T s = (R - (radii.inner + radii.outer) / 2) / (radii.outer - radii.inner);
    const T alpha = amplitude * sin(pi / period * t) * (1 - 8 * s * s + 16 * s * s * s * s);
    const T cosine = cos(alpha), sine = sin(alpha);
    return {cosine * X[0] - sine * X[1] - X[0], sine * X[0] + cosine * X[1] - X[1]};
  }
};

}  // namespace mpmvv::mms
