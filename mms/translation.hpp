#pragma once
#include "mms/solution.hpp"

namespace mpmvv::mms {

/// A body that moves as a whole at a constant velocity: u = V t, v = V, F = I, everything else zero. Across cells a
/// method keeps it to round-off or has an error of its own there.
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

 private:
  Vec<D> velocity_;
  double scale_;
};

}  // namespace mpmvv::mms
