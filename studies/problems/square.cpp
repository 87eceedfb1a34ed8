#include "mms/square.hpp"

#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

Setup<2> square_setup(const Parameters& p) {
  const mms::Elasticity material{p.at("youngs_modulus"), p.at("poissons_ratio"), p.at("density")};
  return {.density = material.density,
          .material = neo_hookean(material.youngs_modulus, material.poissons_ratio),
          .solution = std::make_shared<mms::Square>(p.at("amplitude"), material)};
}

}  // namespace

/// The unit square in plane strain, W §5.1; E, ν and ρ₀ are not printed. The end time is one full period.
Problem square_problem() {
  Parameter amplitude = amplitude_parameter(0.1);
  amplitude.allowed = [](double a) { return a > -0.318 && a < 0.318; };
  amplitude.range = "between -1/pi and 1/pi, where det F stays positive";
  return {.name = "square",
          .source = "Wallstedt and Guilkey 2008, section 5.1",
          .length_formula = "1",
          .length = unit_length,
          .parameters = {amplitude, youngs_modulus_parameter(1e4), poissons_ratio_parameter(0.3), density_parameter(1)},
          .wave_speed_formula = "c = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "2/c",
          .end_time = [](const Parameters& p) { return 2 / bar_wave_speed(p); },
          .boundary = "symmetry",
          .setup = &square_setup};
}

}  // namespace mpmvv::problems
