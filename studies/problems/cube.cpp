#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

Problem cube_in_motion(const char* name, const std::string& source, SetupFunction<3> setup) {
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
          .symmetry_planes = SymmetryPlanes::at_upper_faces,
          .setup = setup};
}

}  // namespace

/// The periodic unit cube, S §5.3. The end time is half a period.
Problem cube_problem() {
  return cube_in_motion("cube", "Steffen et al. 2008, section 5.3",
                        [](const Parameters& p) { return setup_of<3>("cube", p); });
}

/// From rest: for codes that take no initial velocity and deformation. At the end time it has gone farthest.
Problem cube_rest_problem() {
  return cube_in_motion("cube-rest", "as Steffen et al. 2008, section 5.3, from rest",
                        [](const Parameters& p) { return setup_of<3>("cube-rest", p); });
}

}  // namespace mpmvv::problems
