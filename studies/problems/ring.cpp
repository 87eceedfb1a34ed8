#include "mms/ring.hpp"

#include "studies/problems/annulus.hpp"

namespace mpmvv::problems {

namespace {

Setup<2> ring_setup(const Parameters& p) {
  const mms::Elasticity material{p.at("youngs_modulus"), p.at("poissons_ratio"), p.at("density")};
  const auto [inner, outer] = radii(p);
  return {.body = Annulus<2>{inner, outer, outer + std::abs(p.at("amplitude"))},
          .density = material.density,
          .material = neo_hookean(material.youngs_modulus, material.poissons_ratio),
          .solution = std::make_shared<mms::Ring>(p.at("amplitude"), radii(p), material)};
}

}  // namespace

/// The ring that expands and contracts, W §5.2, in plane strain; the radii are not printed. The end time is one full
/// period. With a Poisson's ratio, which W leaves at zero, its surfaces are loaded.
Problem ring_problem() {
  return {.name = "ring",
          .source = "Wallstedt and Guilkey 2008, section 5.2",
          .length_formula = "outer_radius",
          .length = outer_radius,
          .parameters = {radial_amplitude_parameter(), inner_radius_parameter(0.5), outer_radius_parameter(1),
                         youngs_modulus_parameter(1e4), poissons_ratio_parameter(0), density_parameter(1)},
          .objection = radial_motion_objection,
          .wave_speed_formula = "c = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "2/c",
          .end_time = [](const Parameters& p) { return 2 / bar_wave_speed(p); },
          .boundary = "free",
          .symmetry_planes = SymmetryPlanes::at_lower_faces,
          .is_loaded = has_poissons_ratio,
          .setup = &ring_setup};
}

}  // namespace mpmvv::problems
