#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "mms/elasticity.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// How a motion along an axis goes with time: T = rest + swing sin(Cπt + phase).
struct Course {
  double phase = 0, rest = 0, swing = 1;

  /// T = sin²(Cπt/2): at t = 0 the body is at rest and undeformed.
  static constexpr Course from_rest() { return {-std::numbers::pi / 2, 0.5, 0.5}; }
};

/// A motion of the unit interval, square (plane strain) or cube in which each component of u depends on its own
/// coordinate alone:
///   u_d = A sin kπX_d T_d,   T_d a course,   C² = E/ρ₀
///   F_d = 1 + kπA cos kπX_d T_d                      F is diagonal
///   P_d = (λK + μ (F_d² - 1)) / F_d                  K = ln Π F_d
///   b_d = π² A sin kπX_d [k² T_d (λ(1 - K) F_d⁻² + μ (1 + F_d⁻²)) - E (T_d - rest)] / ρ₀
/// With T_d = sin(Cπt + φ_d) and k = 1 these are W (56) to (59), with k = 2 S (51) to (53).
template <int D>
class AxisAligned : public ManufacturedSolution<D> {
 public:
  /// wave_number: k; courses: T_d of each axis.
  AxisAligned(double amplitude, int wave_number, const std::array<Course, D>& courses, const Elasticity& material);

  Vec<D> u(const Vec<D>& X, double t) const final;
  Vec<D> v(const Vec<D>& X, double t) const final;
  Vec<D> a(const Vec<D>& X, double t) const final;
  Mat<D> F(const Vec<D>& X, double t) const final;
  Mat<D> P(const Vec<D>& X, double t) const final;
  Vec<D> b(const Vec<D>& X, double t) const final;

  double displacement_scale() const final { return std::abs(A_); }

  /// Computes what depends on one coordinate once for all points that share it. On a lattice a point costs a few bytes
  /// and additions. Sines and cosines are taken once per distinct coordinate, logarithms and divisions once per
  /// distinct coordinate and time, none per point.
  std::unique_ptr<PointwiseSolution<D>> at_points(const std::vector<Vec<D>>& X) const final;
  expression::Formulas formulas() const final;

 private:
  class AtPoints;

  template <class N>
  N u_along(std::size_t d, const N& X, const N& t) const;  ///< u_d; here and below N is any scalar type
  template <class N>
  N b_along(const N& a, const N& u, const N& F, const N& K) const;  ///< b_d from a_d, u_d, F_d and K

  Vec<D> T(double t) const;
  Vec<D> stretches(const Vec<D>& X, double t) const;  ///< the diagonal of F

  double A_, k_pi_, lambda_, mu_, rho_, C_pi_;
  Vec<D> phases_, rests_, swings_;
};

extern template class AxisAligned<1>;
extern template class AxisAligned<2>;
extern template class AxisAligned<3>;

}  // namespace mpmvv::mms
