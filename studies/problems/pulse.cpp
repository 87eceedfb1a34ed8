#include "mms/pulse.hpp"

#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

constexpr double pulse_length = 0.2, pulse_height = 0.01;  // m

Setup<2> pulse_setup(const Parameters& p) {
  const double E = p.at("youngs_modulus"), density = p.at("density");
  return {.body = Box<2>{.lower = solver::Vec<2>::Zero(), .size = solver::Vec<2>(pulse_length, pulse_height)},
          .density = density,
          .material = solver::LinearElastic{0, E / 2},
          .solution = std::make_shared<mms::Pulse>(p.at("stress"), p.at("duration"), E, density)};
}

}  // namespace

/// A bar whose left end is pulled by a triangle of tension, N §3.3, in plane stress, which without a Poisson's ratio is
/// plane strain. N's bar is 198 mm long, here 200, whole cells of every size: until the end time the wave does not meet
/// the other end.
Problem pulse_problem() {
  return {.name = "pulse",
          .source = "Nairn and Hammerquist 2021, section 3.3",
          .length_formula = "0.01",
          .length = [](const Parameters&) { return pulse_height; },
          .parameters = {youngs_modulus_parameter(1e7), density_parameter(1000),
                         Parameter{"stress", 500, "Pa", [](double s) { return s != 0; }, "not 0"},
                         Parameter{"duration", 1e-3, "s", [](double t) { return t > 0; }, "> 0"}},
          .objection = [](const Parameters& p) -> std::string {
            if (1.5 * p.at("duration") * bar_wave_speed(p) < pulse_length) return "";
            return "the wave meets the other end: 1.5 duration sqrt(youngs_modulus/density) must be less than 0.2 m";
          },
          .wave_speed_formula = "c = sqrt(E/rho)",
          .wave_speed = bar_wave_speed,
          .end_time_formula = "1.5 duration",
          .end_time = [](const Parameters& p) { return 1.5 * p.at("duration"); },
          .boundary = "free",
          .material = std::string(solver::LinearElastic::word),
          .is_loaded = [](const Parameters&) { return true; },
          .setup = &pulse_setup};
}

}  // namespace mpmvv::problems
