#pragma once
#include <Eigen/LU>
#include <array>

#include "mms/elasticity.hpp"

namespace mpmvv::mms {

/// The fields of a displacement by central differences of fourth order and the printed law W (54): nothing of mms but
/// the displacement itself. `Real` is the kind of number that the differences are taken in.
template <int D, class Real, class Displacement>
struct Differences {
  using V = Eigen::Matrix<Real, D, 1>;
  using M = Eigen::Matrix<Real, D, D>;

  Displacement displacement;
  Elasticity material;
  Real step, time_step;

  V u(const V& X, Real t) const {
    std::array<Real, D> place;
    std::copy_n(X.data(), D, place.begin());
    const std::array<Real, D> value = displacement(place, t);
    return Eigen::Map<const V>(value.data());
  }
  V v(const V& X, Real t) const {
    return difference([&](Real s) { return u(X, t + s); }, time_step);
  }
  V a(const V& X, Real t) const {
    return difference([&](Real s) { return v(X, t + s); }, time_step);
  }
  M F(const V& X, Real t) const {
    M F = M::Identity();
    for (int J = 0; J < D; ++J) F.col(J) += difference([&](Real s) { return u(X + s * V::Unit(J), t); }, step);
    return F;
  }
  M P(const V& X, Real t) const {
    using std::log;
    const M stretch = F(X, t), inverse_transpose = stretch.inverse().transpose();
    const Real lambda = material.lambda(), mu = material.mu();
    return lambda * log(stretch.determinant()) * inverse_transpose + mu * (stretch - inverse_transpose);
  }
  V b(const V& X, Real t) const {
    V div_P = V::Zero();
    for (int J = 0; J < D; ++J) div_P += difference([&](Real s) { return P(X + s * V::Unit(J), t); }, step).col(J);
    return a(X, t) - div_P / Real(material.density);
  }

 private:
  template <class Field>
  static auto difference(const Field& field, Real step) {
    return ((8 * (field(step) - field(-step)) - (field(2 * step) - field(-2 * step))) / (12 * step)).eval();
  }
};

}  // namespace mpmvv::mms
