#pragma once
#include <algorithm>
#include <cmath>

#include "mms/solution.hpp"

namespace mpmvv::mms {

/// The triangle of unit height over 0 <= s <= 1, N §3.3, zero outside, and its integral from 0.
struct Triangle {
  static double value(double s) { return std::max(0.0, 1 - std::abs(2 * s - 1)); }
  static double slope(double s) { return s <= 0 || s >= 1 ? 0 : s < 0.5 ? 2 : -2; }
  static double integral(double s) {
    const double r = std::clamp(s, 0.0, 1.0);
    return r < 0.5 ? r * r : 0.5 - (1 - r) * (1 - r);
  }
};

/// The bar of N §3.3 is 198 mm long. This is a whole number of cells at every resolution, m.
inline constexpr double pulse_length = 0.2;

/// A linear elastic bar with ν = 0 that begins at X = 0, where a triangular pulse of tension pulls it, N §3.3. Until
/// the wave meets the other end the motion is d'Alembert's solution, with q = (t - X/c)/duration:
///   P_xx = σ tri(q),   F_xx = 1 + P_xx/E,   u_x = -σ c/E duration ∫₀^q tri,   v_x = -c/E P_xx,   b = 0.
/// (N prints tri(t - cx); a wave of speed c has c in the denominator.) The acceleration jumps where the triangle kinks.
class Pulse final : public ManufacturedSolution<2> {
 public:
  /// `stress` σ in Pa, `duration` in s, `youngs_modulus` in Pa, `density` in kg/m³.
  Pulse(double stress, double duration, double youngs_modulus, double density)
      : stress_(stress), duration_(duration), E_(youngs_modulus), c_(std::sqrt(youngs_modulus / density)) {}

  Vec<2> u(const Vec<2>& X, double t) const override {
    return along_x(-c_ / E_ * stress_ * duration_ * Triangle::integral(phase(X, t)));
  }
  Vec<2> v(const Vec<2>& X, double t) const override { return along_x(-c_ / E_ * tension(X, t)); }
  Vec<2> a(const Vec<2>& X, double t) const override {
    return along_x(-c_ / E_ * stress_ / duration_ * Triangle::slope(phase(X, t)));
  }
  Mat<2> F(const Vec<2>& X, double t) const override {
    Mat<2> F = Mat<2>::Identity();
    F(0, 0) += tension(X, t) / E_;
    return F;
  }
  Mat<2> P(const Vec<2>& X, double t) const override {
    Mat<2> P = Mat<2>::Zero();
    P(0, 0) = tension(X, t);
    return P;
  }
  Vec<2> b(const Vec<2>&, double) const override { return Vec<2>::Zero(); }

  double displacement_scale() const override { return std::abs(c_ / E_ * stress_ * duration_ / 2); }

 private:
  double phase(const Vec<2>& X, double t) const { return (t - X[0] / c_) / duration_; }
  double tension(const Vec<2>& X, double t) const { return stress_ * Triangle::value(phase(X, t)); }
  static Vec<2> along_x(double component) { return {component, 0}; }

  double stress_, duration_, E_, c_;
};

}  // namespace mpmvv::mms
