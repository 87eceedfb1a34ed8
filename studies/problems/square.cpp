#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

Problem square_in_motion(const char* name, const std::string& source, SetupFunction<2> setup) {
  return {.name = name,
          .source = source,
          .length_formula = "1",
          .length = unit_length,
          .parameters = mms::entry_named(name).parameters,
          .wave_speed_formula = "c = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "2/c",
          .end_time = [](const Parameters& p) { return 2 / bar_wave_speed(p); },
          .boundary = "symmetry",
          .setup = setup};
}

}  // namespace

/// The unit square in plane strain, W §5.1. W does not print E, ν and ρ₀. The end time is one full period.
Problem square_problem() {
  return square_in_motion("square", "Wallstedt and Guilkey 2008, section 5.1",
                          [](const Parameters& p) { return setup_of<2>("square", p); });
}

/// The square in motion from rest, for codes that take no initial velocity or deformation. At the end time it is at
/// rest again.
Problem square_rest_problem() {
  return square_in_motion("square-rest", "as Wallstedt and Guilkey 2008, section 5.1, from rest",
                          [](const Parameters& p) { return setup_of<2>("square-rest", p); });
}

/// A square in motion from rest whose body force is an expression of the current position, for codes that evaluate it
/// there.
Problem square_inverse_problem() {
  return square_in_motion("square-inverse", "made for codes that evaluate body forces at current positions",
                          [](const Parameters& p) { return setup_of<2>("square-inverse", p); });
}

}  // namespace mpmvv::problems
