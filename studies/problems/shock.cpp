#include "studies/problems/parameters.hpp"

namespace mpmvv::problems {

namespace {

constexpr double shock_length = 0.05, shock_height = 0.0025;  // m

Parameter positive_parameter(const std::string& name, double value, const std::string& unit) {
  return {name, value, unit, [](double x) { return x > 0; }, "> 0"};
}

Parameter not_negative_parameter(const std::string& name, double value, const std::string& unit) {
  return {name, value, unit, [](double x) { return x >= 0; }, ">= 0"};
}

double bulk_speed(const Parameters& p) {
  return std::sqrt(p.at("bulk_modulus") / p.at("density"));
}

/// A wall at an end of the bar that moves at a constant velocity from the start.
class Piston final : public solver::WallMotion {
 public:
  Piston(double X, double velocity) : X_(X), velocity_(velocity) {}

  double position(double t) const override { return X_ + velocity_ * t; }
  double velocity(double) const override { return velocity_; }
  double gradient(double) const override { return 0; }

 private:
  double X_, velocity_;
};

Setup<2> shock_setup(const Parameters& p) {
  Setup<2> setup{
      .body = Box<2>{.lower = solver::Vec<2>(0, -shock_height / 2), .size = solver::Vec<2>(shock_length, shock_height)},
      .density = p.at("density"),
      .material = solver::MieGruneisen{.density = p.at("density"),
                                       .bulk_modulus = p.at("bulk_modulus"),
                                       .hugoniot_slope = p.at("hugoniot_slope"),
                                       .gamma = p.at("gamma"),
                                       .heat_capacity = p.at("heat_capacity"),
                                       .temperature = p.at("temperature"),
                                       .A1 = p.at("linear_viscosity"),
                                       .A2 = p.at("quadratic_viscosity")},
      .start_velocity = [](const solver::Vec<2>&) { return solver::Vec<2>(0, 0); }};
  setup.walls[0] = std::make_shared<Piston>(0, 0);
  setup.walls[1] = std::make_shared<Piston>(shock_length, -p.at("velocity"));
  return setup;
}

std::string shock_objection(const Parameters& p) {
  const double u = p.at("velocity"), U = bulk_speed(p) + p.at("hugoniot_slope") * u;
  if (4e-6 * U >= shock_length) return "the shock meets the other end before the end time of 4e-6 s: a lower velocity";
  return "";
}

}  // namespace

/// A bar of nickel, 50 by 2.5 mm in plane strain. A wall runs into it from the right at 40 % of the bulk wave speed,
/// N §3.5. Its sides are planes of symmetry (N: walls at rest), and a wall holds its left end. The material is a fluid
/// without shear strength, because N does not print the shear modulus and the yield stress. The heat capacity is that
/// of nickel at 25 °C in the CRC Handbook of Chemistry and Physics. N does not print the end time. At the one
/// chosen here the front is some 21 mm from the left end.
Problem shock_problem() {
  return {
      .name = "shock",
      .source = "Nairn and Hammerquist 2021, section 3.5",
      .length_formula = "0.0025",
      .length = [](const Parameters&) { return shock_height; },
      .parameters = {positive_parameter("bulk_modulus", 188e9, "Pa"), density_parameter(8870),
                     not_negative_parameter("hugoniot_slope", 1.44, ""), not_negative_parameter("gamma", 2, ""),
                     positive_parameter("heat_capacity", 444, "J/(kg K)"), positive_parameter("temperature", 300, "K"),
                     positive_parameter("velocity", 1840, "m/s"), not_negative_parameter("linear_viscosity", 0.4, ""),
                     not_negative_parameter("quadratic_viscosity", 4, "")},
      .objection = shock_objection,
      .wave_speed_formula = "c = sqrt(K/rho)",
      .wave_speed = bulk_speed,
      .end_time_formula = "4e-6",
      .end_time = [](const Parameters&) { return 4e-6; },
      .boundary = "xmin=wall,xmax=wall,ymin=symmetry,ymax=symmetry",
      .material = std::string(solver::MieGruneisen::word),
      .images = solver::Images::middle,
      .setup = &shock_setup};
}

}  // namespace mpmvv::problems
