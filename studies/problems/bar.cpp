#include "mms/bar.hpp"

#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

Setup<1> bar_setup(const Parameters& p) {
  const double E = p.at("youngs_modulus"), rho = p.at("density");
  return {.density = rho,
          .material = neo_hookean(E, 0),
          .solution = std::make_shared<mms::Bar>(p.at("amplitude"), mms::Elasticity{E, 0, rho})};
}

}  // namespace

/// The periodic bar on [0, 1], S §5.2. The wave speed C is that of the solution; its period is 2/C.
Problem bar_problem() {
  Parameter amplitude = amplitude_parameter(0.05);
  amplitude.allowed = [](double a) { return a > -0.159 && a < 0.159; };
  amplitude.range = "between -1/(2 pi) and 1/(2 pi), where det F stays positive";
  return {.name = "bar",
          .source = "Steffen et al. 2008, section 5.2",
          .length_formula = "1",
          .length = unit_length,
          .parameters = {amplitude, youngs_modulus_parameter(1e4), density_parameter(1)},
          .wave_speed_formula = "C = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "1/C",
          .end_time = [](const Parameters& p) { return 1 / bar_wave_speed(p); },
          .boundary = "periodic",
          .setup = &bar_setup};
}

}  // namespace mpmvv::problems
