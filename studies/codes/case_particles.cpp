#include "studies/codes/case_particles.hpp"

#include "solver/mpm.hpp"

namespace mpmvv::codes {

template <int D>
CaseParticles<D> case_particles(const cases::Case& c) {
  auto prepared = runs::prepare_case<D>(c, problems::find_problem(c.problem.name, "the case"), 1);
  const solver::Mpm<D> mpm(std::move(prepared.scene));
  const auto& start = mpm.particles();
  const auto& grid = mpm.grid();
  CaseParticles<D> all{.setup = prepared.setup,
                       .X = prepared.X,
                       .x0 = prepared.X,
                       .m = std::vector<double>(start.size()),
                       .momenta = runs::Momenta<D>(start),
                       .energy = mpm.kinetic_energy() + mpm.strain_energy(),
                       .is_driven = prepared.is_driven,
                       .lower = grid.lower(),
                       .upper = grid.lower(),
                       .period = Vec<D>::Zero(),
                       .h = grid.h(),
                       .spacing = grid.h() / c.resolution.ppc,
                       .dt = c.resolution.dt,
                       .end_time = static_cast<double>(c.resolution.steps) * c.resolution.dt};
  for (std::size_t p = 0; p < start.size(); ++p) {
    all.x0[start.id[p]] = start.x[p];
    all.m[start.id[p]] = start.m[p];
  }
  for (int d = 0; d < D; ++d) {
    const auto axis = static_cast<std::size_t>(d);
    all.upper[d] += grid.h() * grid.cells()[axis];
    if (mpm.periodic()[axis]) all.period[d] = all.upper[d] - all.lower[d];
  }
  return all;
}

template CaseParticles<1> case_particles<1>(const cases::Case&);
template CaseParticles<2> case_particles<2>(const cases::Case&);
template CaseParticles<3> case_particles<3>(const cases::Case&);

}  // namespace mpmvv::codes
