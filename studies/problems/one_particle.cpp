#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

Setup<1> one_particle_setup(const Parameters& p) {
  const double velocity = p.at("velocity");
  return {.density = p.at("density"), .material = material_of(p), .start_velocity = [velocity](const solver::Vec<1>&) {
            return solver::Vec<1>(velocity);
          }};
}

}  // namespace

/// One particle in one cell that is held on the left and free on the right, without a body force, W §3. W does not
/// print the velocity. The default stretches the particle by a twentieth at most.
Problem one_particle_problem() {
  return {.name = "one-particle",
          .source = "Wallstedt and Guilkey 2008, section 3",
          .length_formula = "1",
          .length = unit_length,
          .parameters = {youngs_modulus_parameter(1e4), density_parameter(1),
                         Parameter{"velocity", 5, "m/s", [](double) { return true; }, "any"}},
          .wave_speed_formula = "C = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "2/C",
          .end_time = [](const Parameters& p) { return 2 / bar_wave_speed(p); },
          .boundary = "xmin=dirichlet,xmax=free",
          .is_one_particle = true,
          .setup = &one_particle_setup};
}

}  // namespace mpmvv::problems
