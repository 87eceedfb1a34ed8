#pragma once
#include <algorithm>

#include "solver/mpm.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::runs {

/// The momenta of the particles and their images, and the sums that changes of the momenta are divided by.
template <int D>
struct Momenta {
  solver::Vec<D> linear = solver::Vec<D>::Zero();   ///< Σ m v
  solver::Mat<D> angular = solver::Mat<D>::Zero();  ///< Σ m (x vᵀ - v xᵀ), about the origin; without APIC's C_p
  double speed = 0;                                 ///< Σ m |v|
  double swing = 0;                                 ///< Σ m |x| |v|

  explicit Momenta(const solver::Particles<D>& particles, solver::Images images = solver::Images::none) {
    for (std::size_t p = 0; p < particles.size(); ++p) {
      solver::Vec<D> x = particles.x[p], v = particles.v[p];
      for (int k = 0; k < count(images); ++k) {
        add(particles.m[p], x, v);
        x = next_image(images, x), v = next_image(images, v);
      }
    }
  }

 private:
  void add(double m, const solver::Vec<D>& x, const solver::Vec<D>& v) {
    linear += m * v;
    const solver::Mat<D> moment = m * x * v.transpose();
    angular += moment - moment.transpose();
    speed += m * v.norm();
    swing += m * x.norm() * v.norm();
  }
};

/// Returns the relative changes from start to end. Those of momenta are NaN when nothing moves; that of the angular
/// momentum is also NaN with a periodic axis, where a particle that comes back in on the other side changes its moment.
template <int D>
records::Balance balance(const Momenta<D>& start, const Momenta<D>& end, double mass_of_particles, double mass_of_body,
                         bool is_periodic) {
  return {.mass = mass_of_particles / mass_of_body - 1,
          .momentum = (end.linear - start.linear).norm() / std::max(start.speed, end.speed),
          .angular_momentum = is_periodic ? records::not_measured
                                          : (end.angular - start.angular).norm() / std::max(start.swing, end.swing)};
}

}  // namespace mpmvv::runs
