#pragma once
#include <array>

#include "mms/elasticity.hpp"
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// A bar in uniaxial strain at a constant rate of F, N §3.4, for the law N (6):
///   u_x = rate t X,   v_x = rate X,   a = 0,   F_xx = 1 + rate t = J;               no motion along the other axes
///   P_xx = (λ + 2G) (J - 1/J) / 2,   P_yy = P_zz = λ (J² - 1) / 2,   b = 0
/// With J σ = P Fᵀ these are N's stresses. When λ = 0 the sides are free of stress, so that only the ends have to be
/// held.
template <int D>
class Stretch final : public ManufacturedSolution<D> {
 public:
  /// rate: 1/s; scale: the largest |u| of interest, m.
  Stretch(double rate, const Elasticity& material, double scale) : rate_(rate), material_(material), scale_(scale) {}

  Vec<D> u(const Vec<D>& X, double t) const override { return along_x(rate_ * t * X[0]); }
  Vec<D> v(const Vec<D>& X, double) const override { return along_x(rate_ * X[0]); }
  Vec<D> a(const Vec<D>&, double) const override { return Vec<D>::Zero(); }

  Mat<D> F(const Vec<D>&, double t) const override {
    Mat<D> F = Mat<D>::Identity();
    F(0, 0) += rate_ * t;
    return F;
  }

  Mat<D> P(const Vec<D>& X, double t) const override {
    const double J = F(X, t)(0, 0), lambda = material_.lambda();
    Mat<D> P = lambda * (J * J - 1) / 2 * Mat<D>::Identity();
    P(0, 0) = (lambda + 2 * material_.mu()) * (J - 1 / J) / 2;
    return P;
  }

  Vec<D> b(const Vec<D>&, double) const override { return Vec<D>::Zero(); }

  double displacement_scale() const override { return scale_; }
  expression::Formulas formulas() const override;

 private:
  static Vec<D> along_x(double value) { return value * Vec<D>::Unit(0); }

  double rate_;
  Elasticity material_;
  double scale_;
};

/// The displacement u_x = rate t X alone, for any scalar type.
template <std::size_t D>
struct StretchDisplacement {
  double rate;

  template <class T>
  std::array<T, D> operator()(const std::array<T, D>& X, const T& t) const {
    std::array<T, D> u;
    u.fill(0.0 * t);
    u[0] = rate * t * X[0];
    return u;
  }
};

template <int D>
expression::Formulas Stretch<D>::formulas() const {
  expression::Vector X = expression::vector(expression::current_place<D>());
  X[0] /= 1 + rate_ * expression::time();
  return {.reference =
              expression::motion(expression::displacement<D>(StretchDisplacement<D>{rate_}), expression::nothing(D)),
          .inverse = expression::inverse_motion(X, expression::nothing(D))};
}

}  // namespace mpmvv::mms
