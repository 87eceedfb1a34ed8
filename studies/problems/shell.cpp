#include "mms/shell.hpp"

#include "studies/problems/annulus.hpp"

namespace mpmvv::problems {

namespace {

Setup<3> shell_setup(const Parameters& p) {
  const mms::Elasticity material{p.at("youngs_modulus"), p.at("poissons_ratio"), p.at("density")};
  const auto [inner, outer] = radii(p);
  return {.body = Annulus<3>{inner, outer, outer + std::abs(p.at("amplitude"))},
          .density = material.density,
          .material = neo_hookean(material.youngs_modulus, material.poissons_ratio),
          .solution = std::make_shared<mms::Shell>(p.at("amplitude"), radii(p), material)};
}

}  // namespace

/// The spherical shell that moves as the ring does: its sister in three dimensions.
Problem shell_problem() {
  return {.name = "shell",
          .source = "as Wallstedt and Guilkey 2008, section 5.2, in three dimensions",
          .length_formula = "outer_radius",
          .length = outer_radius,
          .parameters = {radial_amplitude_parameter(), inner_radius_parameter(0.5), outer_radius_parameter(1),
                         youngs_modulus_parameter(1e4), poissons_ratio_parameter(0), density_parameter(1)},
          .objection = radial_motion_objection,
          .wave_speed_formula = "P wave, sqrt((lambda + 2 mu)/rho)",
          .wave_speed = p_wave_speed,
          .end_time_formula = "2/sqrt(E/rho)",
          .end_time = [](const Parameters& p) { return 2 / bar_wave_speed(p); },
          .boundary = "free",
          .symmetry_planes = SymmetryPlanes::at_lower_faces,
          .is_loaded = has_poissons_ratio,
          .setup = &shell_setup};
}

}  // namespace mpmvv::problems
