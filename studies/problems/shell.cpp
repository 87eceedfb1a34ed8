#include "studies/problems/annulus.hpp"

namespace mpmvv::problems {

namespace {

Setup<3> shell_setup(const Parameters& p) {
  Setup<3> setup = setup_of<3>("shell", p);
  const auto [inner, outer] = mms::radii(p);
  setup.body = Annulus<3>{inner, outer, outer + std::abs(p.at("amplitude"))};
  return setup;
}

}  // namespace

/// The spherical shell with the radial motion of the ring.
Problem shell_problem() {
  return {.name = "shell",
          .source = "as Wallstedt and Guilkey 2008, section 5.2, in three dimensions",
          .length_formula = "outer_radius",
          .length = outer_radius,
          .parameters = mms::entry_named("shell").parameters,
          .objection = mms::entry_named("shell").objection,
          .wave_speed_formula = "P wave, sqrt((lambda + 2 mu)/rho)",
          .wave_speed = p_wave_speed,
          .end_time_formula = "2/sqrt(E/rho)",
          .end_time = [](const Parameters& p) { return 2 / bar_wave_speed(p); },
          .boundary = "free",
          .symmetry_planes = SymmetryPlanes::at_lower_faces,
          .images = solver::Images::diagonal,
          .is_loaded = has_poissons_ratio,
          .setup = &shell_setup};
}

}  // namespace mpmvv::problems
