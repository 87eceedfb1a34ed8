#pragma once
#include <fmt/format.h>

#include <limits>
#include <string>

#include "studies/cases/case.hpp"
#include "studies/problems/setup.hpp"

namespace mpmvv::runs {

/// When a case counts as unstable. `is_driven`: walls put energy in, so that it has no bound.
template <int D>
class BlowUp {
 public:
  BlowUp(const cases::Case& c, const problems::Setup<D>& setup, bool is_driven, double initial_energy)
      : most_energy_(is_driven || (setup.solution && initial_energy <= rest(setup))
                         ? std::numeric_limits<double>::infinity()  // all of it comes from outside
                         : c.measure.blowup_energy * initial_energy + rest(setup)),
        most_error_(setup.solution ? c.measure.blowup_error * setup.solution->displacement_scale() + round_off : 0) {}

  // Why it counts as unstable; empty where it does not.
  std::string judge_energy(double energy) const {
    return energy <= most_energy_ ? "" : fmt::format("energy {:.3g} beyond {:.3g}", energy, most_energy_);
  }
  std::string judge_error(double largest) const {
    return largest <= most_error_ ? "" : fmt::format("displacement error {:.3g} beyond {:.3g}", largest, most_error_);
  }

 private:
  static constexpr double round_off = 1e-12;  ///< what a body at rest may move (m) and gain (times density, J)
  static double rest(const problems::Setup<D>& setup) { return round_off * setup.density; }
  double most_energy_, most_error_;
};

}  // namespace mpmvv::runs
