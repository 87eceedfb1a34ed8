#pragma once
#include <cmath>
#include <vector>

#include "studies/codes/snapshot.hpp"
#include "studies/runs/balance.hpp"
#include "studies/runs/prepared_case.hpp"

namespace mpmvv::codes {

using solver::Vec;

/// What a case starts with, its particles in the order in which they fill the body, and the room that they have.
template <int D>
struct CaseParticles {
  problems::Setup<D> setup;
  std::vector<Vec<D>> X, x0;  ///< reference positions, and positions at time zero
  std::vector<double> m;
  runs::Momenta<D> momenta;
  double energy;  ///< kinetic and strain energy
  bool is_driven;
  Vec<D> lower, upper;  ///< corners of the background grid
  Vec<D> period;        ///< its length along axes on which it is periodic; 0 along others
  double h;             ///< cell width
  double spacing;       ///< about what particles are apart at rest
  double dt, end_time;  ///< the time at which outputs are scored

  std::size_t size() const { return X.size(); }

  /// Where the particle is at time t.
  Vec<D> exact(std::size_t particle, double t) const { return X[particle] + setup.solution->u(X[particle], t); }

  /// The way from b to a: across periodic faces the shortest one.
  Vec<D> difference(const Vec<D>& a, const Vec<D>& b) const {
    Vec<D> way = a - b;
    for (int d = 0; d < D; ++d)
      if (period[d] > 0) way[d] -= period[d] * std::round(way[d] / period[d]);
    return way;
  }
};

template <int D>
CaseParticles<D> case_particles(const cases::Case& c);

extern template CaseParticles<1> case_particles<1>(const cases::Case&);
extern template CaseParticles<2> case_particles<2>(const cases::Case&);
extern template CaseParticles<3> case_particles<3>(const cases::Case&);

/// Its coordinates as the problem has them.
template <int D>
Vec<D> vec(const Point& point) {
  return Eigen::Map<const Vec<D>>(point.data());
}

template <int D>
std::vector<Vec<D>> vecs(const std::vector<Point>& points) {
  std::vector<Vec<D>> all;
  all.reserve(points.size());
  for (const Point& point : points) all.push_back(vec<D>(point));
  return all;
}

}  // namespace mpmvv::codes
