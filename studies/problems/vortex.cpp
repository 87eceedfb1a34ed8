#include "studies/problems/annulus.hpp"

namespace mpmvv::problems {

namespace {

Setup<2> vortex_setup(const Parameters& p) {
  Setup<2> setup = setup_of<2>("vortex", p);
  const auto [inner, outer] = mms::radii(p);
  setup.body = Annulus<2>{inner, outer, outer};
  return setup;
}

}  // namespace

/// The generalized vortex: an annulus in which each circle turns by an angle of its own, and those of the surfaces stay
/// at rest. At the end time it has turned out and back.
Problem vortex_problem() {
  return {.name = "vortex",
          .source = "Kamojjala, Brannon, Sadeghirad and Guilkey 2015",
          .length_formula = "outer_radius",
          .length = outer_radius,
          .parameters = mms::entry_named("vortex").parameters,
          .objection = mms::entry_named("vortex").objection,
          .wave_speed_formula = "P wave, sqrt((lambda + 2 mu)/rho)",
          .wave_speed = p_wave_speed,
          .end_time_formula = "period",
          .end_time = [](const Parameters& p) { return p.at("period"); },
          .boundary = "free",
          .images = solver::Images::quarter_turns,
          .setup = &vortex_setup};
}

}  // namespace mpmvv::problems
