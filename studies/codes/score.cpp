#include "studies/codes/score.hpp"

#include <fmt/format.h>

#include "studies/codes/matching.hpp"
#include "studies/codes/output_fault.hpp"
#include "studies/runs/norms.hpp"
#include "studies/support/reason.hpp"

namespace mpmvv::codes {

using records::Record;
using records::Status;

namespace {

/// Displacement of each line's particle.
template <int D>
Vec<D> displacement(const CaseParticles<D>& particles, const Snapshot& end, std::size_t line, std::size_t particle) {
  if (!end.u.empty()) return vec<D>(end.u[line]);
  return vec<D>(end.x[line]) - particles.X[particle];
}

template <int D>
void measure(const CaseParticles<D>& particles, const Output& output, Record& record) {
  const std::vector<std::size_t> particle = match(particles, output);
  runs::ErrorNorms norms;
  for (std::size_t line = 0; line < particle.size(); ++line) {
    const Vec<D> exact = particles.setup.solution->u(particles.X[particle[line]], particles.end_time);
    norms.add(particles.difference(displacement(particles, output.end, line, particle[line]), exact).norm());
  }
  record.error.l1 = norms.l1();
  record.error.l2 = norms.l2();
  record.error.linf = norms.linf();
}

}  // namespace

Record score(const cases::Case& c, const Output& output) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  Record record;
  record.the_case = c;
  record.steps = c.resolution.steps;
  record.cfl = problem.wave_speed(c.problem.parameters) * c.resolution.dt * c.resolution.cells /
               problem.length(c.problem.parameters);
  try {
    std::visit(
        [&]<int D>(problems::SetupFunction<D>) {
          const CaseParticles<D> particles(c);
          record.particles = static_cast<std::int64_t>(particles.size());
          measure(particles, output, record);
        },
        problem.setup);
  } catch (const OutputFault& fault) {
    record.status = fault.status;
    record.failure = fault.status == Status::failed ? records::Failure::of_case : records::Failure::none;
    record.reason = fault.what();
  }
  return record;
}

}  // namespace mpmvv::codes
