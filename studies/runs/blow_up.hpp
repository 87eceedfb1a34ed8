#pragma once
#include <fmt/format.h>

#include <limits>
#include <string>

#include "studies/cases/case.hpp"
#include "studies/problems/setup.hpp"

namespace mpmvv::runs {

/// What a body at rest may move by round-off, m, and by density gain, J/(kg/m³).
inline constexpr double rest_round_off = 1e-12;

/// The most energy of a body that is at rest but for round-off, J.
template <int D>
double rest_energy(const problems::Setup<D>& setup) {
  return rest_round_off * setup.density;
}

/// An energy at the start, or zero where the solution starts from rest and this is its round-off.
template <int D>
double start_energy(const problems::Setup<D>& setup, double measured) {
  return setup.solution && measured <= rest_energy(setup) ? 0 : measured;
}

/// When a case counts as unstable. `is_driven`: walls put energy in, so that it has no bound.
template <int D>
class BlowUp {
 public:
  BlowUp(const cases::Case& c, const problems::Setup<D>& setup, bool is_driven, double initial_energy)
      : most_energy_(is_driven || (setup.solution && initial_energy <= rest_energy(setup))
                         ? std::numeric_limits<double>::infinity()  // all of it comes from outside
                         : c.measure.blowup_energy * initial_energy + rest_energy(setup)),
        most_error_(setup.solution ? c.measure.blowup_error * setup.solution->displacement_scale() + rest_round_off
                                   : 0) {}

  // Why it counts as unstable; empty where it does not.
  std::string judge_energy(double energy) const {
    return energy <= most_energy_ ? "" : fmt::format("energy {:.3g} beyond {:.3g}", energy, most_energy_);
  }
  std::string judge_error(double largest) const {
    return largest <= most_error_ ? "" : fmt::format("displacement error {:.3g} beyond {:.3g}", largest, most_error_);
  }

 private:
  double most_energy_, most_error_;
};

}  // namespace mpmvv::runs
