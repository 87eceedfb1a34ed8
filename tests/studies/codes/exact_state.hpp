#pragma once
#include "studies/codes/case_particles.hpp"
#include "tests/studies/codes/written_run.hpp"

namespace mpmvv::written_run {

/// The exact positions and velocities at a time, with ids, masses and reference positions.
template <int D>
codes::Snapshot exact_state(const codes::CaseParticles<D>& particles, double t) {
  codes::Snapshot s{.file = "end.csv"};
  for (std::size_t p = 0; p < particles.size(); ++p) {
    s.id.push_back(static_cast<std::int64_t>(p) + 1);
    s.X.push_back(point<D>(particles.X[p]));
    s.x.push_back(point<D>(particles.exact(p, t)));
    s.v.push_back(point<D>(particles.setup.solution->v(particles.X[p], t)));
    s.mass.push_back(particles.m[p]);
  }
  return s;
}

}  // namespace mpmvv::written_run
