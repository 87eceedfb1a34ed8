#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

constexpr double length = 0.05, height = 0.02;  // of a block, m
constexpr int gap = 4;                          // cells

using solver::NeoHookeanSquare;
using solver::Vec;

Setup<2> impact_setup(const Parameters& p) {
  const double speed = p.at("velocity");
  return {.body = Blocks<2>{.size = {length, height}, .gap_cells = gap, .room = 0.02},
          .density = p.at("density"),
          .material = material_of<NeoHookeanSquare>(p),
          .start_velocity = [speed](const Vec<2>& X) { return Vec<2>(X[0] < length ? speed : -speed, 0); }};
}

double impact_time(const Parameters& p) {
  return 3 * length / p_wave_speed(p);
}

/// Returns the time until the blocks meet, rounded up so that the end time is a whole multiple of 10 us, which time
/// steps can divide.
double lead_time(const Parameters& p, double h) {
  constexpr double grain = 1e-5;
  const double end = impact_time(p) + gap * h / (2 * p.at("velocity"));
  return grain * std::ceil(end / grain) - impact_time(p);
}

}  // namespace

/// Two elastic blocks of 50 by 20 mm in plane strain, 4 cells apart, that run into each other and part again, N §3.1.
/// Their speed is 10 % of sqrt(E/ρ₀), with ρ₀ = 1500, which N does not print. The impact takes two passages of the
/// pressure wave through a block. The end time is three passages and the time until the blocks meet.
Problem impact_problem() {
  return {.name = "impact",
          .source = "Nairn and Hammerquist 2021, section 3.1",
          .length_formula = "0.01",
          .length = [](const Parameters&) { return 0.01; },
          .parameters = {youngs_modulus_parameter(1e7), poissons_ratio_parameter(0.33), density_parameter(1500),
                         Parameter{"velocity", 8.165, "m/s", [](double v) { return v > 0; }, "> 0"}},
          .wave_speed_formula = "c = sqrt((lambda + 2 G)/rho)",
          .wave_speed = p_wave_speed,
          .end_time_formula = "0.15/c, and 2 h/velocity until the blocks meet, up to whole 10 us",
          .end_time = impact_time,
          .lead_time = lead_time,
          .boundary = "free",
          .material = std::string(NeoHookeanSquare::word),
          .symmetry_planes = SymmetryPlanes::at_upper_faces,
          .setup = &impact_setup};
}

}  // namespace mpmvv::problems
