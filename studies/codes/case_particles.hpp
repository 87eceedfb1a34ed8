#pragma once
#include <cmath>
#include <vector>

#include "studies/codes/snapshot.hpp"
#include "studies/runs/balance.hpp"
#include "studies/runs/prepared_case.hpp"

namespace mpmvv::codes {

using solver::Vec;

/// The particles with which a case starts, in the order in which they fill the body, and its grid. SI units.
template <int D>
struct CaseParticles {
  problems::Setup<D> setup;
  std::vector<Vec<D>> X, x0;  ///< reference positions, and positions at time zero
  std::vector<double> m;
  runs::Momenta<D> momenta;
  double energy;  ///< kinetic and strain energy at time zero
  bool is_driven;
  Vec<D> lower, upper;  ///< corners of the background grid
  Vec<D> period;        ///< length of the grid along its periodic axes; 0 along others
  double h;             ///< cell width
  double spacing;       ///< about the distance between neighbouring particles at rest
  double dt, end_time;  ///< time step; time at which outputs are scored

  std::size_t size() const { return X.size(); }

  /// Returns the exact position of the particle at time t.
  Vec<D> exact(std::size_t particle, double t) const { return X[particle] + setup.solution->u(X[particle], t); }

  /// Returns a - b, the shortest such vector where the grid is periodic.
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

/// Returns the coordinates that a problem in D dimensions has.
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
