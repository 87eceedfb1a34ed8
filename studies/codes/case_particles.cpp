#include "studies/codes/case_particles.hpp"

#include <cmath>

namespace mpmvv::codes {

template <int D>
CaseParticles<D>::CaseParticles(const cases::Case& c) {
  auto prepared = runs::prepare_case<D>(c, problems::find_problem(c.problem.name, "the case"), 1);
  const auto& scene = prepared.scene;
  X = prepared.X;
  x0.resize(X.size());
  m.resize(X.size());
  for (std::size_t p = 0; p < X.size(); ++p) {
    x0[scene.particles.id[p]] = scene.particles.x[p];
    m[scene.particles.id[p]] = scene.particles.m[p];
  }
  lower = upper = scene.lower;
  for (int d = 0; d < D; ++d) upper[d] += scene.h * scene.cells[static_cast<std::size_t>(d)];
  spacing = scene.h / c.resolution.ppc;
  end_time = static_cast<double>(c.resolution.steps) * c.resolution.dt;
  setup = prepared.setup;
  const solver::Mpm<D> mpm(std::move(prepared.scene));
  initial_energy = mpm.kinetic_energy() + mpm.strain_energy();
  for (int d = 0; d < D; ++d) period[d] = mpm.periodic()[static_cast<std::size_t>(d)] ? upper[d] - lower[d] : 0;
}

template struct CaseParticles<1>;
template struct CaseParticles<2>;
template struct CaseParticles<3>;

}  // namespace mpmvv::codes
