#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

/// The undeformed periodic unit square, which moves as a whole across its cells. Errors are round-off, or come from
/// particles that change cells. By the end time it has moved by about half its length along x.
Problem translation_problem() {
  return {.name = "translation",
          .source = "made for codes without body forces",
          .length_formula = "1",
          .length = unit_length,
          .parameters = mms::entry_named("translation").parameters,
          .wave_speed_formula = "P wave, sqrt((lambda + 2 mu)/rho)",
          .wave_speed = p_wave_speed,
          .end_time_formula = "2/c",
          .end_time = [](const Parameters& p) { return 2 / p_wave_speed(p); },
          .boundary = "periodic",
          .setup = [](const Parameters& p) { return setup_of<2>("translation", p); }};
}

}  // namespace mpmvv::problems
