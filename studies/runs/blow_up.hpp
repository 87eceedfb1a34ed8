#pragma once
#include <fmt/format.h>

#include <limits>
#include <string>

#include "studies/cases/case.hpp"
#include "studies/problems/setup.hpp"
#include "studies/runs/prepared_case.hpp"

namespace mpmvv::runs {

/// The limit of round-off in the displacements of a body at rest, m.
inline constexpr double rest_round_off = 1e-12;

/// Returns the most energy, in J, that round-off gives a body at rest: a part of its mass times the wave speed squared.
template <int D>
double rest_energy(const cases::Case& c, const problems::Setup<D>& setup) {
  const double speed = problems::find_problem(c.problem.name, "the case").wave_speed(c.problem.parameters);
  return 1e-15 * mass_of(setup) * speed * speed;
}

/// Returns the energy measured at the start, or zero where the solution starts from rest and the energy is round-off.
template <int D>
double start_energy(const cases::Case& c, const problems::Setup<D>& setup, double measured) {
  return setup.solution && measured <= rest_energy(c, setup) ? 0 : measured;
}

/// Decides when a case counts as unstable. `is_driven` says that walls put energy in, so that the energy has no bound.
template <int D>
class BlowUp {
 public:
  BlowUp(const cases::Case& c, const problems::Setup<D>& setup, bool is_driven, double initial_energy)
      : most_energy_(is_driven || (setup.solution && initial_energy <= rest_energy(c, setup))
                         ? std::numeric_limits<double>::infinity()  // all energy comes from outside
                         : c.measure.blowup_energy * initial_energy + rest_energy(c, setup)),
        most_error_(setup.solution ? c.measure.blowup_error * setup.solution->displacement_scale() + rest_round_off
                                   : 0) {}

  // These return why the run counts as unstable, or an empty string where it does not.
  std::string judge_energy(double energy) const {
    return energy <= most_energy_ ? "" : fmt::format("energy {:.4g} beyond {:.3g}", energy, most_energy_);
  }
  std::string judge_error(double largest) const {
    return largest <= most_error_ ? "" : fmt::format("displacement error {:.4g} beyond {:.3g}", largest, most_error_);
  }

 private:
  double most_energy_, most_error_;
};

}  // namespace mpmvv::runs
