#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

Problem bar_in_motion(const char* name, const std::string& source, SetupFunction<1> setup) {
  return {.name = name,
          .source = source,
          .length_formula = "1",
          .length = unit_length,
          .parameters = mms::entry_named(name).parameters,
          .wave_speed_formula = "C = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "1/C",
          .end_time = [](const Parameters& p) { return 1 / bar_wave_speed(p); },
          .boundary = "periodic",
          .setup = setup};
}

}  // namespace

/// The periodic bar on [0, 1], S §5.2. The wave speed C is that of the solution; its period is 2/C.
Problem bar_problem() {
  return bar_in_motion("bar", "Steffen et al. 2008, section 5.2",
                       [](const Parameters& p) { return setup_of<1>("bar", p); });
}

/// From rest: for codes that take no initial velocity and deformation. At the end time it has gone farthest.
Problem bar_rest_problem() {
  return bar_in_motion("bar-rest", "as Steffen et al. 2008, section 5.2, from rest",
                       [](const Parameters& p) { return setup_of<1>("bar-rest", p); });
}

}  // namespace mpmvv::problems
