#include "mms/wave.hpp"

#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

Setup<2> wave_setup(const Parameters& p) {
  Setup<2> setup = setup_of<2>("wave", p);
  setup.material = material_of<solver::LinearElastic>(p);
  const mms::Wave wave(p.at("amplitude"), mms::elasticity(p));
  setup.other_law = {.material = material_of<solver::NeoHookeanLog>(p),
                     .solution_error = [wave](double t) { return wave.nonlinear_error(t); }};
  return setup;
}

}  // namespace

/// A standing wave along x in the unit square without a body force, for codes that have none. It is the exact solution
/// for small strain. For a body with a law of finite strain it has an error, which `mms/wave.hpp` bounds. The end time
/// is one full period.
Problem wave_problem() {
  return {.name = "wave",
          .source = "made for codes without body forces",
          .length_formula = "1",
          .length = unit_length,
          .parameters = mms::entry_named("wave").parameters,
          .wave_speed_formula = "P wave, sqrt((lambda + 2 mu)/rho)",
          .wave_speed = p_wave_speed,
          .end_time_formula = "2/c",
          .end_time = [](const Parameters& p) { return 2 / p_wave_speed(p); },
          .boundary = "symmetry",
          .material = std::string(solver::LinearElastic::word),
          .other_material = std::string(solver::NeoHookeanLog::word),
          .setup = &wave_setup};
}

}  // namespace mpmvv::problems
