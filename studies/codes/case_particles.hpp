#pragma once
#include <vector>

#include "studies/codes/snapshot.hpp"
#include "studies/runs/scene.hpp"

namespace mpmvv::codes {

using solver::Vec;

/// The particles that a case starts with, in the order in which they fill the body, and the room that they have.
template <int D>
struct CaseParticles {
  explicit CaseParticles(const cases::Case& c);

  problems::Setup<D> setup;
  std::vector<Vec<D>> X, x0;  ///< reference positions, and positions at time zero
  std::vector<double> m;
  Vec<D> lower, upper;    ///< corners of the background grid
  Vec<D> period;          ///< its length along axes on which it is periodic; 0 along others
  double spacing = 0;     ///< about what particles are apart at rest
  double end_time = 0;    ///< at which outputs are scored
  double initial_energy;  ///< kinetic and strain energy

  std::size_t size() const { return X.size(); }

  /// The way from b to a: across periodic faces the shortest one.
  Vec<D> difference(const Vec<D>& a, const Vec<D>& b) const {
    Vec<D> way = a - b;
    for (int d = 0; d < D; ++d)
      if (period[d] > 0) way[d] -= period[d] * std::round(way[d] / period[d]);
    return way;
  }
};

extern template struct CaseParticles<1>;
extern template struct CaseParticles<2>;
extern template struct CaseParticles<3>;

template <int D>
Vec<D> vec(const Point& point) {
  return Eigen::Map<const Vec<D>>(point.data());
}

}  // namespace mpmvv::codes
