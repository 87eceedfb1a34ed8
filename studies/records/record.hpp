#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/fits/paired_rounds.hpp"
#include "studies/support/not_measured.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::records {

using support::not_measured;
using support::to_string;

/// `unstable` is a result of the method (blown up); `failed` is not (the run could not be carried out).
enum class Status { ok, unstable, failed };
constexpr std::array<const char*, 3> words_of(Status) {
  return {"ok", "unstable", "failed"};
}

/// Why a run `failed`. A failure of the machine (no memory, no threads, a full disk) may be gone at the next try; a
/// failure of the case comes back.
enum class Failure { none, of_case, of_machine };
constexpr std::array<const char*, 3> words_of(Failure) {
  return {"none", "case", "machine"};
}

Failure failure_of(const std::exception& e);  ///< of_machine: bad_alloc, system_error, WriteError; else of_case

/// Norms of the displacement error δ_p over the particles, W (64), (65): mean, root mean square, maximum.
struct Errors {
  double l1 = not_measured, l2 = not_measured, linf = not_measured;
  double l1_all_steps = not_measured, l2_all_steps = not_measured, linf_all_steps = not_measured;
  /// Norms of the acceleration error δ_i over the nodes of the body at the end, W (A.2), in m/s².
  double nodal_l1 = not_measured, nodal_l2 = not_measured, nodal_linf = not_measured;
  /// Velocity error: RMS over the particles, averaged over all steps, in per cent of the problem's speed, N §3.4.
  double velocity = not_measured;
  /// Error of the Cauchy stress at the end: RMS over the particles of the difference's Frobenius norm, in Pa.
  double stress = not_measured;
};

/// Relative changes of what must not change. `mass`: mass of the particles over that of the body, less one. `momentum`
/// and `angular_momentum`: change from start to end, divided by Σ m |v| and by Σ m |x| |v|, each taken at start or end,
/// whichever is larger. Only a free body conserves these two.
struct Balance {
  double mass = not_measured, momentum = not_measured, angular_momentum = not_measured;
};

/// Energies (unit_of_energy), at the end unless named initial. With a staggered integrator (cd, uvf) the velocities,
/// and so the kinetic energy, are those of half a step earlier.
struct Energy {
  double kinetic = not_measured, strain = not_measured, initial_total = not_measured;
};

/// The fraction of the initial energy that is gone at the end; negative where energy was gained, NaN where there was
/// none to lose.
inline double energy_loss(const Energy& e) {
  return e.initial_total > 0 ? 1 - (e.kinetic + e.strain) / e.initial_total : not_measured;
}

/// Cost measured alone on the machine, in the processor time of one thread: the geometric mean of the repetitions, and
/// their range divided by it.
struct Cost {
  double step_seconds = not_measured;  ///< step loop alone
  double spread = not_measured;
  fits::Rounds rounds = {};  ///< in ns per particle and step
};

/// The displacement error of a particle at the end, or the RMS of neighbours where there are many, in m.
struct ParticleError {
  double x = 0, y = 0;  ///< where it is, seen along z, in m
  double error = 0;
};

/// What came out of one case.
struct Record {
  cases::Case the_case;
  std::int64_t particles = 0;  ///< of the whole body
  std::int64_t steps = 0;      ///< steps really taken
  double cfl = not_measured;   ///< not measured where another code chose its time step
  Status status = Status::ok;
  Failure failure = Failure::none;  ///< why it `failed`; runs in older stores have none even then
  std::string reason;               ///< why it is `unstable` or `failed`; empty for `ok`
  Errors error;
  Energy energy;
  Balance balance;
  double wall_seconds = not_measured;          ///< of one run; other runs may have shared the machine
  int threads = 1;                             ///< that shared it; runs in older stores have one
  double ns_per_particle_step = not_measured;  ///< step loop alone; a mean where the case asks for its cost
  double output_floor = not_measured;    ///< RMS displacement error made by the rounding of another code's output, m
  double solution_floor = not_measured;  ///< RMS displacement error of a solution not exact for the body's law, m
  double images = 1;  ///< images of the part that was run, itself included, that make up the body; 1: all of it was run
  Cost cost = {};     ///< where the case asks for it
  std::vector<ParticleError> particle_errors =
      {};  ///< where the case asks for them; without the mirror images of a quarter
};

/// Whether another code chose the time step. The case's `dt` and `steps` are then not those of the run.
inline bool has_own_step(const Record& r) {
  return !r.the_case.scheme.code.empty() && std::isnan(r.cfl);
}

/// Whether the number of steps is unknown: the code chose the step, and its output does not say how many there were.
inline bool has_unknown_steps(const Record& r) {
  return has_own_step(r) && r.steps == 0;
}

/// Whether another try may succeed. A failure of another code always counts: nobody knows whether it only lacked a
/// licence or a library.
inline bool is_worth_another_try(const Record& r) {
  return r.status == Status::failed && (r.failure != Failure::of_case || !r.the_case.scheme.code.empty());
}

/// A number of a run.
struct RunNumber {
  const char* name;  ///< by which stores, fits and figures know it
  const char* path;  ///< its place in `mpmvv run --json`
  const double& (*get)(const Record&);
  double& (*set)(Record&);
  int schema;                ///< the first schema of the store that has a column for it
  std::string unit = {};     ///< empty for ratios
  std::string setting = {};  ///< the key that asks for it; empty where it is always measured
};

/// `run_errors`: errors and balances; `run_by_products`: all other numbers. A new number of a run is named in one of
/// these two lists and nowhere else.
const std::vector<RunNumber>& run_errors();
const std::vector<RunNumber>& run_by_products();

/// The unit of an energy of a body: in 2D it is that of a metre's depth, in 1D that of a square metre. Without a
/// dimension (0) it says all of this.
std::string unit_of_energy(int dimension);

/// The unit of a number of a run of bodies in this dimension; empty for ratios and whatever else there is.
std::string unit_of(const std::string& quantity, int dimension = 0);
std::string with_unit(const std::string& quantity, int dimension = 0);  ///< "dt (s)", for the head of a column

/// What fits, criteria and goldens may ask of a run: its errors and balances, and the energy loss.
const std::vector<std::string>& norm_words();

}  // namespace mpmvv::records
