#pragma once
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// A body that moves as a whole at a constant velocity: u = V t, v = V, F = I, everything else zero. A method
/// either keeps this motion to round-off, or makes an error where particles change cells.
template <int D>
class Translation final : public ManufacturedSolution<D> {
 public:
  /// velocity: m/s; scale: the largest |u| of interest, m.
  Translation(const Vec<D>& velocity, double scale) : velocity_(velocity), scale_(scale) {}

  Vec<D> u(const Vec<D>&, double t) const override { return t * velocity_; }
  Vec<D> v(const Vec<D>&, double) const override { return velocity_; }
  Vec<D> a(const Vec<D>&, double) const override { return Vec<D>::Zero(); }
  Mat<D> F(const Vec<D>&, double) const override { return Mat<D>::Identity(); }
  Mat<D> P(const Vec<D>&, double) const override { return Mat<D>::Zero(); }
  Vec<D> b(const Vec<D>&, double) const override { return Vec<D>::Zero(); }

  double displacement_scale() const override { return scale_; }

  expression::Formulas formulas() const override {
    expression::Vector u, X;
    for (int d = 0; d < D; ++d) {
      u.push_back(velocity_[d] * expression::time());
      X.push_back(expression::current_place<D>()[static_cast<std::size_t>(d)] - u.back());
    }
    return {.reference = expression::motion(u, expression::nothing(D)),
            .inverse = expression::inverse_motion(X, expression::nothing(D))};
  }

 private:
  Vec<D> velocity_;
  double scale_;
};

}  // namespace mpmvv::mms
