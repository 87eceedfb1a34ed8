#include "studies/codes/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

#include "studies/codes/displacement_checks.hpp"
#include "studies/codes/excursion.hpp"
#include "studies/codes/matching.hpp"
#include "studies/codes/output_checks.hpp"
#include "studies/codes/output_fault.hpp"
#include "studies/codes/planted.hpp"
#include "studies/codes/rounding.hpp"
#include "studies/codes/stresses.hpp"
#include "studies/runs/blow_up.hpp"
#include "studies/runs/norms.hpp"
#include "studies/runs/particle_errors.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::codes {

using records::Record;
using records::Status;

namespace {

/// Finds the particles of the lines at the end, and their displacements: those that are written, else x - X.
template <int D>
MatchedEnd<D> matched(const CaseParticles<D>& particles, const Output& output) {
  MatchedEnd<D> end{particles, output.end, match(particles, output), {}};
  for (std::size_t line = 0; line < end.size(); ++line)
    end.u.push_back(output.end.u.empty() ? Vec<D>(vec<D>(output.end.x[line]) - particles.X[end.particle[line]])
                                         : vec<D>(output.end.u[line]));
  return end;
}

/// Returns the norms over all lines of what `error` gives for each.
template <int D, class Error>
runs::ErrorNorms norms_of(const MatchedEnd<D>& end, const Error& error) {
  runs::ErrorNorms norms;
  for (std::size_t line = 0; line < end.size(); ++line) norms.add(error(line, end.particles.X[end.particle[line]]));
  return norms;
}

/// Returns the RMS velocity error at the end, in per cent of the problem's speed.
template <int D>
double velocity_error(const MatchedEnd<D>& end) {
  const auto& setup = end.particles.setup;
  const auto norms = norms_of(end, [&](std::size_t line, const Vec<D>& X) {
    return (vec<D>(end.snapshot.v[line]) - setup.solution->v(X, end.particles.end_time)).norm();
  });
  return 100 / setup.speed * norms.l2();
}

/// Returns the particles of an end with velocities. Their masses are those of the case if none are written.
template <int D>
solver::Particles<D> moving_particles(const MatchedEnd<D>& end) {
  solver::Particles<D> all;
  all.resize(end.size());
  for (std::size_t line = 0; line < end.size(); ++line) {
    all.x[line] = end.x(line);
    all.v[line] = vec<D>(end.snapshot.v[line]);
    all.m[line] = end.snapshot.mass.empty() ? end.particles.m[end.particle[line]] : end.snapshot.mass[line];
  }
  return all;
}

/// Measures kinetic energy and balance as far as the output has velocities and masses.
template <int D>
void measure_balance(const MatchedEnd<D>& end, Record& record) {
  const CaseParticles<D>& particles = end.particles;
  const double body = runs::mass_of(particles.setup);
  double mass = 0;
  for (const double m : end.snapshot.mass) mass += m;
  if (end.snapshot.v.empty()) {
    if (!end.snapshot.mass.empty()) record.balance.mass = mass / body - 1;
    return;
  }
  const solver::Particles<D> moving = moving_particles(end);
  record.balance = runs::balance(particles.momenta, runs::Momenta<D>(moving), mass, body, !particles.period.isZero(0));
  if (end.snapshot.mass.empty()) record.balance.mass = records::not_measured;
  record.energy.kinetic = 0;
  for (std::size_t line = 0; line < end.size(); ++line)
    record.energy.kinetic += moving.m[line] * moving.v[line].squaredNorm() / 2;
}

template <int D>
std::vector<records::ParticleError> particle_errors(const MatchedEnd<D>& end) {
  runs::ParticleErrors errors(D, end.particles.spacing);
  for (std::size_t line = 0; line < end.size(); ++line)
    errors.add<D>(end.particles.X[end.particle[line]], end.x(line), end.error(line, end.particles.end_time).norm());
  return errors.reduced();
}

void require_stable(const std::string& reason) {
  if (!reason.empty()) throw OutputFault(Status::unstable, reason);
}

template <int D>
void measure(const CaseParticles<D>& particles, const Output& output, Record& record) {
  const cases::Case& c = record.the_case;
  record.particles = static_cast<std::int64_t>(particles.size());
  record.energy.initial_total = runs::start_energy(c, particles.setup, particles.energy);
  require_last_step(c, output.end);
  require_end_time(c, output.end);
  require_finite(output, particles.size());
  const MatchedEnd<D> end = matched(particles, output);
  require_length_units(end);
  require_same_displacements(end);
  require_displacements_from_rest(end);
  require_inside(end);
  const bool says_when = output.end.time || output.end.step == c.resolution.steps;
  const bool may_differ = is_planted(c);  // a planted mistake is meant to have large errors
  if (!says_when && !may_differ) require_time(end);
  const bool may_rest = may_differ && c.scheme.force_form == cases::ForceForm::none;
  if (!may_rest) require_motion(end);
  require_mass(end);
  const runs::BlowUp<D> blow_up(c, particles.setup, particles.is_driven, particles.energy);
  const auto norms =
      norms_of(end, [&](std::size_t line, const Vec<D>&) { return end.error(line, particles.end_time).norm(); });
  const std::string beyond = blow_up.judge_error(norms.linf());
  require_stable(beyond.empty() ? beyond : beyond + common_offset(end));
  require_velocity_units(end);
  measure_balance(end, record);
  if (!output.end.v.empty()) require_stable(blow_up.judge_energy(record.energy.kinetic));
  if (c.measure.stress_error && !c.scheme.code.empty()) require_stresses(output.end);
  if (c.measure.stress_error) require_stress_units(end);
  record.error.l1 = norms.l1();
  record.error.l2 = norms.l2();
  record.error.linf = norms.linf();
  if (c.measure.particle_errors) record.particle_errors = particle_errors(end);
  record.output_floor = rounding_error(output.end.rounding);
  record.solution_floor = problems::solution_floor(particles.setup, particles.end_time);
  if (c.measure.stress_error && !output.end.stress.empty()) record.error.stress = stress_error(end);
  if (c.measure.velocity_error && !output.end.v.empty()) record.error.velocity = velocity_error(end);
}

/// Measures the output against the case. Throws OutputFault if that is not possible.
void measure(const problems::Problem& problem, const Output& output, Record& record) {
  const cases::Case& c = record.the_case;
  for (const Snapshot* s : {output.start ? &*output.start : nullptr, &output.end})
    if (s) require_same_case(c, *s);
  const auto measure_in = [&]<int D>(problems::SetupFunction<D>) {
    CaseParticles<D> particles = case_particles<D>(c);
    if (output.time) particles.end_time = *output.time;
    measure(particles, output, record);
  };
  std::visit(measure_in, problem.setup);
}

/// Takes the time that a code states, if it is within the tolerance, as the one at which the output is measured.
void settle_time(const cases::Case& c, const Stepping& stepping, Output& output) {
  const double end_time = static_cast<double>(c.resolution.steps) * c.resolution.dt;
  std::optional<double>& time = output.end.time;
  if (!time) return;
  if (!(std::abs(*time - end_time) <= stepping.time_tolerance * end_time))
    fail_output("{} is of the time {:.10g} s and not of the end time {:.10g} s (time_tolerance of the adapter: {:g})",
                output.end.file, *time, end_time, stepping.time_tolerance);
  if (!is_end_time(c, *time)) output.time = time;
  time = end_time;
}

/// Leaves out what the output of a code that chooses its time step says of that step: the case has another.
void leave_out_own_step(Output& output) {
  for (Snapshot* s : {output.start ? &*output.start : nullptr, &output.end})
    if (s) {
      s->step.reset();
      for (const char* key : {"dt", "cfl", "steps"}) s->leave_out(key);
    }
}

/// Returns the record of the case with what `measure_it` measures. It throws OutputFault if it cannot.
Record record_of(const cases::Case& c, const std::function<void(const problems::Problem&, Record&)>& measure_it) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  if (!problem.has_solution(c.problem.parameters))
    throw support::UsageError(fmt::format(
        "problem '{}' has no exact solution with these parameters to score by (other ones, or another problem)",
        problem.name));
  Record record;
  record.the_case = c;
  record.steps = c.resolution.steps;
  record.cfl = problems::cfl_number(c);
  try {
    measure_it(problem, record);
  } catch (const OutputFault& fault) {
    record.status = fault.status;
    record.failure = fault.status == Status::failed ? records::Failure::of_case : records::Failure::none;
    record.reason = fault.what();
    record.balance = {};
    record.energy.kinetic = records::not_measured;
  }
  return record;
}

}  // namespace

Record score(const cases::Case& c, const Output& output) {
  return record_of(c, [&](const problems::Problem& problem, Record& record) { measure(problem, output, record); });
}

Record score(const cases::Case& c, const Stepping& stepping, Output output) {
  const std::optional<std::int64_t> step = output.end.step;
  Record record = record_of(c, [&](const problems::Problem& problem, Record& measured) {
    if (!stepping.is_given) leave_out_own_step(output);
    settle_time(c, stepping, output);
    measure(problem, output, measured);
  });
  if (!stepping.is_given) {
    record.steps = std::max<std::int64_t>(step.value_or(0), 0);
    record.cfl = records::not_measured;
  }
  return record;
}

std::string caution(const cases::Case& c) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  const Excursion exact =
      std::visit([&]<int D>(problems::SetupFunction<D>) { return excursion(case_particles<D>(c)); }, problem.setup);
  if (exact.farthest == 0 || exact.at_end > 1e-6 * exact.farthest) return "";
  return fmt::format(
      "at the end of the case, {:.4g} s, the exact solution is where it started: a code that does nothing has no error "
      "(a case with another --end-time, such as {:.3g})",
      c.problem.end_time, exact.time);
}

}  // namespace mpmvv::codes
