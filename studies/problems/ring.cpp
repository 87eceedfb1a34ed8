#include "studies/problems/annulus.hpp"

namespace mpmvv::problems {

namespace {

Setup<2> ring_setup(const Parameters& p) {
  Setup<2> setup = setup_of<2>("ring", p);
  const auto [inner, outer] = mms::radii(p);
  setup.body = Annulus<2>{inner, outer, outer + std::abs(p.at("amplitude"))};
  return setup;
}

}  // namespace

/// The ring that expands and contracts, W §5.2, in plane strain. W does not print the radii. The end time is one full
/// period. In W Poisson's ratio is zero. With another one the surfaces are loaded.
Problem ring_problem() {
  return {.name = "ring",
          .source = "Wallstedt and Guilkey 2008, section 5.2",
          .length_formula = "outer_radius",
          .length = outer_radius,
          .parameters = mms::entry_named("ring").parameters,
          .objection = mms::entry_named("ring").objection,
          .wave_speed_formula = "c = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "2/c",
          .end_time = [](const Parameters& p) { return 2 / bar_wave_speed(p); },
          .boundary = "free",
          .symmetry_planes = SymmetryPlanes::at_lower_faces,
          .images = solver::Images::diagonal,
          .is_loaded = has_poissons_ratio,
          .setup = &ring_setup};
}

}  // namespace mpmvv::problems
