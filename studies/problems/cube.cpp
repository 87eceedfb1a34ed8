#include "mms/cube.hpp"

#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

Setup<3> cube_setup(const Parameters& p) {
  const mms::Elasticity material{p.at("youngs_modulus"), p.at("poissons_ratio"), p.at("density")};
  return {.density = material.density,
          .material = neo_hookean(material.youngs_modulus, material.poissons_ratio),
          .solution = std::make_shared<mms::Cube>(p.at("amplitude"), material)};
}

}  // namespace

/// The periodic unit cube, S §5.3. The end time is half a period.
Problem cube_problem() {
  Parameter amplitude = amplitude_parameter(0.05);
  amplitude.allowed = [](double a) { return a > -0.159 && a < 0.159; };
  amplitude.range = "between -1/(2 pi) and 1/(2 pi), where det F stays positive";
  return {.name = "cube",
          .source = "Steffen et al. 2008, section 5.3",
          .length_formula = "1",
          .length = unit_length,
          .parameters = {amplitude, youngs_modulus_parameter(1e4), poissons_ratio_parameter(0.3), density_parameter(1)},
          .wave_speed_formula = "C = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "1/C",
          .end_time = [](const Parameters& p) { return 1 / bar_wave_speed(p); },
          .boundary = "periodic",
          .symmetry_planes = SymmetryPlanes::at_upper_faces,
          .setup = &cube_setup};
}

}  // namespace mpmvv::problems
