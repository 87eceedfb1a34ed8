#include "studies/codes/excursion.hpp"

#include "studies/runs/norms.hpp"

namespace mpmvv::codes {

namespace {

/// Returns the RMS distance of the exact solution at time t from its start. Of 500 particles or more it takes every
/// `stride`th, 250 at least.
template <int D>
double distance_from_start(const CaseParticles<D>& particles, double t) {
  const std::size_t stride = particles.size() / 500 + 1;
  const auto& solution = *particles.setup.solution;
  runs::ErrorNorms norms;
  for (std::size_t p = 0; p < particles.size(); p += stride) {
    const Vec<D>& X = particles.X[p];
    norms.add(particles.difference(solution.u(X, t), solution.u(X, 0)).norm());
  }
  return norms.l2();
}

}  // namespace

template <int D>
Excursion excursion(const CaseParticles<D>& particles) {
  constexpr int times = 20;
  Excursion found{.at_end = distance_from_start(particles, particles.end_time)};
  for (int k = 1; k <= times; ++k) {
    const double t = particles.end_time * k / times, distance = distance_from_start(particles, t);
    if (distance > found.farthest) found.farthest = distance, found.time = t;
  }
  return found;
}

template Excursion excursion<1>(const CaseParticles<1>&);
template Excursion excursion<2>(const CaseParticles<2>&);
template Excursion excursion<3>(const CaseParticles<3>&);

}  // namespace mpmvv::codes
