#include "mms/pulse.hpp"

#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

constexpr double pulse_height = 0.01;  // m

Setup<2> pulse_setup(const Parameters& p) {
  Setup<2> setup = setup_of<2>("pulse", p);
  setup.material = material_of<solver::LinearElastic>(p);
  setup.body =
      Box<2>{.lower = solver::Vec<2>(0, -pulse_height / 2), .size = solver::Vec<2>(mms::pulse_length, pulse_height)};
  return setup;
}

}  // namespace

/// A bar whose left end is pulled by a triangular pulse of tension, N §3.3, in plane stress, which is plane strain
/// without a Poisson's ratio. The wave does not meet its other end before the end time.
Problem pulse_problem() {
  return {.name = "pulse",
          .source = "Nairn and Hammerquist 2021, section 3.3",
          .length_formula = "0.01",
          .length = [](const Parameters&) { return pulse_height; },
          .parameters = mms::entry_named("pulse").parameters,
          .objection = mms::entry_named("pulse").objection,
          .wave_speed_formula = "c = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "1.5 duration",
          .end_time = [](const Parameters& p) { return 1.5 * p.at("duration"); },
          .boundary = "free",
          .material = std::string(solver::LinearElastic::word),
          .images = solver::Images::middle,
          .is_loaded = [](const Parameters&) { return true; },
          .setup = &pulse_setup};
}

}  // namespace mpmvv::problems
