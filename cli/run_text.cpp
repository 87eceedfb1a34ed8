#include "cli/run_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/console.hpp"
#include "cli/lines.hpp"
#include "cli/numbers.hpp"
#include "cli/table.hpp"
#include "studies/problems/problem.hpp"

namespace mpmvv::cli {

using records::Record;
using Kind = Table::Kind;

namespace {

/// Of a run the velocity error is the mean over all steps; of an output it is that at the end, which is all there is.
enum class VelocityError { of_all_steps, at_the_end };

const char* to_string(VelocityError which) {
  return which == VelocityError::at_the_end ? "velocity at the end (% of speed)"
                                            : "velocity, mean of all steps (% of speed)";
}

void print_errors(const Record& r, VelocityError velocity) {
  const cases::Measure& asked = r.the_case.measure;
  Table table({{"error"}, {"l1", Kind::number}, {"l2", Kind::number}, {"linf", Kind::number}});
  const auto add = [&table](const char* what, double l1, double l2, double linf) {
    if (!std::isnan(l1) || !std::isnan(l2) || !std::isnan(linf))
      table.add({what, error_text(l1), error_text(l2), error_text(linf)});
  };
  const records::Errors& e = r.error;
  add("displacement at the end (m)", e.l1, e.l2, e.linf);
  if (asked.every_step) add("displacement, largest of all steps (m)", e.l1_all_steps, e.l2_all_steps, e.linf_all_steps);
  if (asked.nodal_error) add("nodal acceleration at the end (m/s2)", e.nodal_l1, e.nodal_l2, e.nodal_linf);
  constexpr double none = records::not_measured;
  if (asked.velocity_error) add(to_string(velocity), none, e.velocity, none);
  if (asked.stress_error) add("stress at the end (Pa)", none, e.stress, none);
  table.print_apart();
}

/// Prints energies and what must not change. Changes of momenta are left out where only a part was run: its images
/// cancel them, which shows no conservation.
void print_balance(const Record& r) {
  Table table({{"measured"}, {"is", Kind::number}});
  const auto add = [&table](const std::string& what, double number) {
    if (!std::isnan(number)) table.add({what, error_text(number)});
  };
  const int dimension = problems::find_problem(r.the_case.problem.name, "the case").dimension();
  const std::string unit = records::unit_of_energy(dimension);
  add(fmt::format("kinetic energy at the end ({})", unit), r.energy.kinetic);
  add(fmt::format("strain energy at the end ({})", unit), r.energy.strain);
  add(fmt::format("energy at the start ({})", unit), r.energy.initial_total);
  add("change of mass", r.balance.mass);
  if (r.images == 1) {
    add("change of momentum", r.balance.momentum);
    add("change of angular momentum", r.balance.angular_momentum);
  }
  add("error that the output's digits make (m)", r.output_floor);
  add("error of the solution for this law (m)", r.solution_floor);
  table.print_apart();
}

/// The steps that were taken; where nothing ran, those asked for.
std::string steps_text(const Record& r) {
  const cases::Resolution& asked = r.the_case.resolution;
  const auto count = [](std::int64_t steps) { return count_text(static_cast<std::size_t>(steps), "step"); };
  if (records::has_own_step(r))
    return (records::has_unknown_steps(r) ? "steps" : count(r.steps)) + " that the code chooses";
  return fmt::format("{} of {:.6g} s (cfl {:.4g})", count(r.particles > 0 ? r.steps : asked.steps), asked.dt, r.cfl);
}

/// How finely the problem was resolved, and what came of it.
void print_outcome(const Record& r, VelocityError velocity) {
  const cases::Resolution& resolution = r.the_case.resolution;
  print("cells {}, ppc {}{}\n", resolution.cells, resolution.ppc,
        r.particles > 0 ? fmt::format(": {} particles", r.particles) : "");
  if (r.images > 1) print("a part was run, of which {} images make the body (--whole runs all of it)\n", r.images);
  print("{}, end time {:.6g} s\n", steps_text(r), r.the_case.problem.end_time);
  print("status {}{}\n", to_string(r.status), r.reason.empty() ? "" : " (" + r.reason + ")");
  print_errors(r, velocity);
  print_balance(r);
}

}  // namespace

void print_score(const Record& r, const std::string& files, int digits) {
  print("{} as another code has solved it: {}, {}\n", r.the_case.problem.name, files,
        count_text(static_cast<std::size_t>(digits), "digit"));
  print_outcome(r, VelocityError::at_the_end);
}

void print_record(const Record& r) {
  const cases::Scheme& s = r.the_case.scheme;
  if (s.code.empty())
    print_indented(fmt::format("{} with basis {}, integrator {}, velocity update {}, boundary {}",
                               r.the_case.problem.name, s.basis, s.integrator, s.velocity_update, s.boundary),
                   0);
  else
    print("{} with code {} ({}), {}body force {}\n", r.the_case.problem.name, s.code, s.code_version,
          s.variant.empty() ? "" : fmt::format("variant {}, ", s.variant), to_string(s.force_form));
  print_outcome(r, VelocityError::of_all_steps);
  if (!std::isnan(r.ns_per_particle_step))
    print("\ntook {}, {:.2f} ns per particle{} and step\n", duration_text(r.wall_seconds), r.ns_per_particle_step,
          r.images > 1 ? " of the part" : "");
  else if (records::has_unknown_steps(r) && !std::isnan(r.wall_seconds))
    print("\ntook {}\n", duration_text(r.wall_seconds));
  if (!std::isnan(r.cost.step_seconds))
    print("cost {} s of {}, geometric mean of {} rounds (range {:.0f} %)\n", error_text(r.cost.step_seconds),
          s.code.empty() ? "steps" : "the process", r.the_case.measure.repeat, 100 * r.cost.spread);
}

}  // namespace mpmvv::cli
