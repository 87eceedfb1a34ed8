#pragma once
#include <fmt/format.h>

#include <limits>
#include <string>

#include "studies/cases/case.hpp"
#include "studies/problems/setup.hpp"

namespace mpmvv::runs {

/// Limits of round-off in a body at rest: for displacements in m, and for energies per density in J/(kg/m³).
inline constexpr double rest_round_off = 1e-12;

/// Returns the most energy, in J, that round-off gives a body at rest.
template <int D>
double rest_energy(const problems::Setup<D>& setup) {
  return rest_round_off * setup.density;
}

/// Returns the energy measured at the start, or zero where the solution starts from rest and the energy is round-off.
template <int D>
double start_energy(const problems::Setup<D>& setup, double measured) {
  return setup.solution && measured <= rest_energy(setup) ? 0 : measured;
}

/// Decides when a case counts as unstable. `is_driven` says that walls put energy in, so that the energy has no bound.
template <int D>
class BlowUp {
 public:
  BlowUp(const cases::Case& c, const problems::Setup<D>& setup, bool is_driven, double initial_energy)
      : most_energy_(is_driven || (setup.solution && initial_energy <= rest_energy(setup))
                         ? std::numeric_limits<double>::infinity()  // all energy comes from outside
                         : c.measure.blowup_energy * initial_energy + rest_energy(setup)),
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
