#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "mms/elasticity.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// The one-dimensional periodic bar on [0, 1], S §5.2, with ν = 0:
///   u = A sin 2πX cos Cπt                        S (47)
///   F = 1 + 2πA cos 2πX cos Cπt                  S (48)
///   P = E/2 (F - 1/F)                            S (50), P = σ in 1D
///   b = C²π² u (2 F⁻² + 1),  C² = E/ρ₀           S (49)
class Bar final : public ManufacturedSolution<1> {
 public:
  Bar(double amplitude, const Elasticity& material);

  Vec<1> u(const Vec<1>& X, double t) const override;
  Vec<1> v(const Vec<1>& X, double t) const override;
  Vec<1> a(const Vec<1>& X, double t) const override;
  Mat<1> F(const Vec<1>& X, double t) const override;
  Mat<1> P(const Vec<1>& X, double t) const override;
  Vec<1> b(const Vec<1>& X, double t) const override;

  double displacement_scale() const override { return std::abs(A_); }
  std::unique_ptr<PointwiseSolution<1>> at_points(const std::vector<Vec<1>>& X) const override;
  expression::Formulas formulas() const override;

 private:
  template <class N>
  N u_at(const N& X, const N& t) const;  ///< here and in the members below N is any scalar type
  template <class N>
  N F_at(const N& X, const N& t) const;
  template <class N>
  N b_at(const N& X, const N& t) const;

  double A_, E_, C_;
};

/// The displacement S (47) alone, for any scalar type. All other fields can be derived from it and an energy.
struct BarDisplacement {
  double amplitude, wave_speed;

  template <class T>
  std::array<T, 1> operator()(const std::array<T, 1>& X, const T& t) const {
    using std::cos, std::sin;
    return {amplitude * sin(two_pi * X[0]) * cos(wave_speed * two_pi / 2 * t)};
  }

  static constexpr double two_pi = 2 * std::numbers::pi;
};

}  // namespace mpmvv::mms
