#include <stdexcept>
#include <string>

#include "studies/checks/profiles/shocked_bar.hpp"

namespace mpmvv::checks {

namespace {

void add_method(const profiles::ShockMethod& method, const mms::Hugoniot& shock, CheckResult& result) {
  const profiles::ShockedBar bar(method, 10, "4e-6", shock);
  const std::string label = method.label();
  result.add_curve("pressure, " + label, bar.pressure.x, bar.pressure.y);
  result.add_curve("temperature, " + label, bar.temperature.x, bar.temperature.y);
  result.add("plateau, " + label, bar.plateau(bar.pressure).mean / shock.pressure() - 1,
             "mean pressure of the plateau over theory - 1");
  result.add("overshoot, " + label, bar.ringing().largest / shock.pressure() - 1,
             "largest pressure within 24 cells behind the front over theory - 1");
  result.add("speed, " + label, bar.front / bar.expected_front - 1, "way of the front over theory - 1");
  result.add("temperature, " + label, bar.plateau(bar.temperature).mean / shock.temperature() - 1,
             "mean temperature of the plateau over theory - 1");
}

/// Returns how much of the run is done when it blows up, as a fraction; 1 where it does not.
double reach(const profiles::ShockMethod& method) {
  profiles::MovingBody<2> bar(method.settings(10, "4e-6"), solver::Images::middle);
  try {
    bar.step_to(bar.resolution().steps);
  } catch (const std::runtime_error&) {
    return static_cast<double>(bar.mpm().steps()) / static_cast<double>(bar.resolution().steps);
  }
  return 1;
}

void add_theory(const mms::Hugoniot& shock, CheckResult& result) {
  const double t = 4e-6, end = 0.05, front = end - shock.shock_speed() * t,
               wall = end - std::sqrt(2 * shock.energy()) * t;
  const std::vector<double> x{0, front, front, wall};
  result.add_curve("pressure, theory", x, {0, 0, shock.pressure(), shock.pressure()});
  const double at_rest =
      problems::complete_parameters(problems::find_problem("shock", "the check"), {}).at("temperature");
  result.add_curve("temperature, theory", x, {at_rest, at_rest, shock.temperature(), shock.temperature()});
}

}  // namespace

/// Measures pressure and temperature along the shocked bar at 4 µs with the methods of N Fig. 8: claims N-fig8, N-temp.
CheckResult check_shock_profiles() {
  constexpr profiles::ShockMethod methods[] = {{"FLIP", "flip", "", true},     {"XPIC(4)", "xpic", "4", true},
                                               {"FMPM(1)", "fmpm", "1", true}, {"FMPM(2)", "fmpm", "2", true},
                                               {"FMPM(4)", "fmpm", "4", true}, {"FMPM(8)", "fmpm", "8", true, true},
                                               {"FLIP", "flip", "", false},    {"FMPM(4)", "fmpm", "4", false}};
  const mms::Hugoniot shock = profiles::theoretical_shock();
  CheckResult result;
  add_theory(shock, result);
  for (const profiles::ShockMethod& method : methods) add_method(method, shock, result);
  result.add("reach, FMPM(8)", reach({"FMPM(8)", "fmpm", "8", true}), "part of the run done when it blew up, else 1");
  return result;
}

}  // namespace mpmvv::checks
