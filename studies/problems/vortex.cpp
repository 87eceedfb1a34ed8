#include "mms/vortex.hpp"

#include "studies/problems/annulus.hpp"

namespace mpmvv::problems {

namespace {

Setup<2> vortex_setup(const Parameters& p) {
  const mms::Elasticity material{p.at("youngs_modulus"), p.at("poissons_ratio"), p.at("density")};
  const auto [inner, outer] = radii(p);
  return {.body = Annulus<2>{inner, outer, outer},
          .density = material.density,
          .material = neo_hookean(material.youngs_modulus, material.poissons_ratio),
          .solution = std::make_shared<mms::Vortex>(p.at("amplitude"), radii(p), p.at("period"), material)};
}

}  // namespace

/// The generalized vortex: an annulus whose circles turn by angles of their own, those of the surfaces not at all. The
/// end time takes it out and back.
Problem vortex_problem() {
  return {
      .name = "vortex",
      .source = "Kamojjala, Brannon, Sadeghirad and Guilkey 2015",
      .length_formula = "outer_radius",
      .length = outer_radius,
      .parameters = {Parameter{"amplitude", 1, "rad", [](double) { return true; }, "any"}, inner_radius_parameter(0.75),
                     outer_radius_parameter(1.25), Parameter{"period", 1, "s", [](double t) { return t > 0; }, "> 0"},
                     youngs_modulus_parameter(1000), poissons_ratio_parameter(0.3), density_parameter(1000)},
      .objection = radii_objection,
      .wave_speed_formula = "P wave, sqrt((lambda + 2 mu)/rho)",
      .wave_speed = p_wave_speed,
      .end_time_formula = "period",
      .end_time = [](const Parameters& p) { return p.at("period"); },
      .boundary = "free",
      .setup = &vortex_setup};
}

}  // namespace mpmvv::problems
