#include "studies/runs/run_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <exception>
#include <functional>
#include <optional>

#include "studies/runs/balance.hpp"
#include "studies/runs/blow_up.hpp"
#include "studies/runs/nodal_error.hpp"
#include "studies/runs/prepared_case.hpp"
#include "studies/runs/rounds.hpp"
#include "studies/runs/run_errors.hpp"
#include "studies/runs/vtu.hpp"
#include "studies/support/error.hpp"
#include "studies/support/reason.hpp"

namespace mpmvv::runs {

using cases::Case;
using records::Record;
using records::Status;

namespace {

/// Returns the processor time of this thread in seconds. It contains no waiting for a processor; but other programs
/// share caches, memory and the clock's frequency, and so change it.
double processor_seconds() {
  timespec spent{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return static_cast<double>(spent.tv_sec) + 1e-9 * static_cast<double>(spent.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A run is checked for instability after every so many steps and at its end.
constexpr std::int64_t watch_interval = 32;

/// Returns why the run counts as unstable; empty while it does not.
template <int D>
std::string judge(const BlowUp<D>& blow_up, const solver::Mpm<D>& mpm, const PreparedCase<D>& prepared) {
  const std::string reason = blow_up.judge_energy(mpm.kinetic_energy() + mpm.strain_energy());
  return !reason.empty() || !prepared.points ? reason : blow_up.judge_error(displacement_errors(mpm, prepared).linf());
}

void note_errors_over_steps(records::Errors& errors, const ErrorNorms& now) {
  // A NaN value replaces a number.
  const auto larger = [](double so_far, double value) { return value <= so_far ? so_far : value; };
  errors.l1_all_steps = larger(errors.l1_all_steps, now.l1());
  errors.l2_all_steps = larger(errors.l2_all_steps, now.l2());
  errors.linf_all_steps = larger(errors.linf_all_steps, now.linf());
}

/// Runs steps to the end or until the run blows up, and calls `observe` after every `stride` sound steps. Returns the
/// seconds spent in the steps alone: the processor's of one thread, else the clock's.
template <int D, class Observe>
double advance(solver::Mpm<D>& mpm, const PreparedCase<D>& prepared, const Case& c, int threads, std::int64_t stride,
               Record& record, const Observe& observe) {
  const BlowUp<D> blow_up(c, prepared.setup, prepared.is_driven, record.energy.initial_total);
  const auto clock = threads == 1 ? &processor_seconds : &wall_seconds;
  double step_seconds = 0;
  while (record.steps < c.resolution.steps) {
    const std::int64_t left = c.resolution.steps - record.steps;
    const double start = clock();
    record.steps += mpm.advance(c.resolution.dt, std::min(stride, left));
    step_seconds += clock() - start;
    record.reason = mpm.fault();
    const bool due = record.steps % watch_interval == 0 || record.steps == c.resolution.steps;
    if (record.reason.empty() && due) record.reason = judge(blow_up, mpm, prepared);
    if (record.reason.empty() && record.steps == c.resolution.steps && !mpm.check()) record.reason = mpm.fault();
    if (!record.reason.empty()) {
      record.status = Status::unstable;
      record.reason += fmt::format(" at step {} of {}", record.steps, c.resolution.steps);
      break;
    }
    observe();
  }
  return step_seconds;
}

/// Measures a sound run at its end.
template <int D>
void measure_end(const Case& c, solver::Mpm<D>& mpm, const PreparedCase<D>& prepared, Record& record) {
  record.energy.kinetic = mpm.kinetic_energy();
  record.energy.strain = mpm.strain_energy();
  if (c.measure.stress_error) record.error.stress = stress_error(mpm, prepared);
  if (prepared.points) {
    const ErrorNorms norms = displacement_errors(mpm, prepared);
    record.error.l1 = norms.l1();
    record.error.l2 = norms.l2();
    record.error.linf = norms.linf();
    if (c.measure.particle_errors) record.particle_errors = particle_errors(mpm, prepared, c.resolution.ppc);
    record.solution_floor = problems::solution_floor(prepared.setup, mpm.time());
  }
  if (c.measure.nodal_error) {
    const ErrorNorms norms = acceleration_errors(mpm, *prepared.setup.solution, prepared.setup.body);
    record.error.nodal_l1 = norms.l1();
    record.error.nodal_l2 = norms.l2();
    record.error.nodal_linf = norms.linf();
  }
}

/// How a case is run. Nothing but the cost depends on it.
struct Manner {
  int threads = 1;
  solver::Images images = solver::Images::none;
  std::function<void(std::int64_t)> tell_steps = nullptr;
};

template <int D>
void run(const Case& c, const problems::Problem& problem, const Manner& manner, VtuSeries* vtu, Record& record) {
  const double start = wall_seconds();
  PreparedCase<D> prepared = prepare_case<D>(c, problem, manner.threads, manner.images);
  solver::Mpm<D> mpm(std::move(prepared.scene));
  for (const std::uint32_t id : mpm.particles().id) record.particles += prepared.count_of(id);
  record.energy.initial_total = start_energy(c, prepared.setup, mpm.kinetic_energy() + mpm.strain_energy());
  const Momenta<D> start_momenta(mpm.particles(), prepared.images);

  const bool every_step = c.measure.every_step && prepared.points;
  if (every_step) record.error.l1_all_steps = record.error.l2_all_steps = record.error.linf_all_steps = 0;
  if (vtu) vtu->write(mpm, prepared.X);
  VelocityError<D> velocity_error;
  const std::int64_t stride = every_step || vtu || c.measure.velocity_error ? 1 : watch_interval;
  const double step_seconds = advance(mpm, prepared, c, manner.threads, stride, record, [&] {
    if (every_step) note_errors_over_steps(record.error, displacement_errors(mpm, prepared));
    if (c.measure.velocity_error) velocity_error.note(mpm, prepared);
    if (vtu && VtuSeries::due(record.steps, c.resolution.steps)) vtu->write(mpm, prepared.X);
    if (manner.tell_steps) manner.tell_steps(record.steps);
  });
  if (record.status == Status::ok) {
    record.balance = balance(start_momenta, Momenta<D>(mpm.particles(), prepared.images), mpm.mass(),
                             mass_of(prepared.setup), std::ranges::find(mpm.periodic(), true) != mpm.periodic().end());
    if (c.measure.velocity_error) record.error.velocity = 100 / prepared.setup.speed * velocity_error.mean();
    measure_end(c, mpm, prepared, record);
  } else {
    record.error = {};
  }
  record.ns_per_particle_step =
      1e9 * step_seconds / (static_cast<double>(mpm.particles().size()) * static_cast<double>(record.steps));
  record.wall_seconds = wall_seconds() - start;
}

/// Runs the steps of a sound case once more, with nothing else in between, and returns their cost in ns per particle
/// and step.
template <int D>
double cost_of_steps(const Case& c, const problems::Problem& problem) {
  PreparedCase<D> prepared = prepare_case<D>(c, problem, 1);
  solver::Mpm<D> mpm(std::move(prepared.scene));
  const double start = processor_seconds();
  mpm.advance(c.resolution.dt, c.resolution.steps);
  const double seconds = processor_seconds() - start;
  return 1e9 * seconds / (static_cast<double>(mpm.particles().size()) * static_cast<double>(c.resolution.steps));
}

/// Returns the record of a case that `work` fills in, whatever the dimension. It has failed where `work` throws.
template <class Work>
Record record_of(const Case& c, const Work& work) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  Record record;
  record.the_case = c;
  record.cfl = problems::cfl_number(c);
  try {
    std::visit([&]<int D>(problems::SetupFunction<D>) { work.template operator()<D>(problem, record); }, problem.setup);
  } catch (const support::UsageError&) {
    throw;
  } catch (const std::exception& e) {
    record.status = Status::failed;
    record.failure = records::failure_of(e);
    record.reason = support::reason_of(e);
  }
  return record;
}

Record run_once(const Case& c, const Manner& manner, VtuSeries* vtu) {
  return record_of(
      c, [&]<int D>(const problems::Problem& problem, Record& record) { run<D>(c, problem, manner, vtu, record); });
}

}  // namespace

Record run_case(const Case& c, int threads, const Output& output) {
  if (c.measure.repeat > 0) return time_in_rounds({run_untimed(c)}, time_steps).front();
  std::optional<VtuSeries> frames;
  if (!output.vtu.empty()) frames.emplace(output.vtu);
  return run_once(c, {.threads = threads, .tell_steps = output.steps}, frames ? &*frames : nullptr);
}

Record run_without_images(const Case& c, solver::Images images, int threads,
                          const std::function<void(std::int64_t)>& tell_steps) {
  return run_once(c, {.threads = threads, .images = images, .tell_steps = tell_steps}, nullptr);
}

Record run_untimed(const Case& c) {
  return run_once(c, {}, nullptr);
}

Record time_steps(const Case& c) {
  return record_of(c, [&c]<int D>(const problems::Problem& problem, Record& record) {
    record.ns_per_particle_step = cost_of_steps<D>(c, problem);
  });
}

}  // namespace mpmvv::runs
