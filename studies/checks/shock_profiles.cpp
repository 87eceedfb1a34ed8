#include <algorithm>
#include <cmath>
#include <string>

#include "mms/hugoniot.hpp"
#include "studies/checks/profile.hpp"

namespace mpmvv {

namespace {

/// A velocity update of N Fig. 8, with or without artificial viscosity.
struct ShockMethod {
  const char *name, *update, *order;
  bool viscous;

  std::string label() const { return std::string(name) + (viscous ? "" : ", no artificial viscosity"); }

  std::vector<Setting> settings() const {
    std::vector<Setting> all{{"problem", "shock", ""},
                             {"basis", "b2cpdi", ""},
                             {"integrator", "usl", ""},
                             {"deformation", "exponential", ""},
                             {"velocity_update", update, ""},
                             {"wall_depth", "1.5", ""},
                             {"wall_gradient", "estimated", ""},
                             {"cells", "10", ""},
                             {"ppc", "2", ""},
                             {"cfl", "0.2", ""}};
    if (*order)
      all.push_back({"order", order, ""});
    else
      all.push_back({"position", "second-order", ""});
    if (!viscous)
      for (const char* key : {"param.linear_viscosity", "param.quadratic_viscosity"}) all.push_back({key, "0", ""});
    return all;
  }
};

/// The shock of the problem's defaults.
mms::Hugoniot theoretical_shock() {
  const Parameters p = complete_parameters(find_problem("shock", "the check"), {});
  return {{p.at("bulk_modulus"), p.at("density"), p.at("hugoniot_slope"), p.at("gamma"), p.at("heat_capacity"),
           p.at("temperature")},
          p.at("velocity")};
}

/// Where the profile first rises through half of `plateau`, seen from the left.
double front_of(const Profile& profile, double plateau) {
  for (std::size_t k = 1; k < profile.x.size(); ++k) {
    const double before = profile.y[k - 1], after = profile.y[k], half = plateau / 2;
    if (after >= half) return profile.x[k - 1] + (profile.x[k] - profile.x[k - 1]) * (half - before) / (after - before);
  }
  return profile.x.back();
}

/// Of the values between two places.
struct PlateauRange {
  double mean = 0, largest = 0;

  PlateauRange(const Profile& profile, double from, double to) {
    double count = 0;
    for (std::size_t k = 0; k < profile.x.size(); ++k)
      if (profile.x[k] >= from && profile.x[k] <= to)
        mean += profile.y[k], ++count, largest = std::max(largest, profile.y[k]);
    mean /= count;
  }
};

void add_method(const ShockMethod& method, const mms::Hugoniot& shock, CheckResult& result) {
  MovingBody<2> bar(method.settings());
  bar.step_to(bar.resolution().steps);
  const auto& particles = bar.mpm().particles();
  const double h = bar.mpm().grid().h(), t = bar.mpm().time(), end = 0.05;
  const Profile pressure = profile(bar, [&](std::size_t p) { return particles.thermal[p].total_pressure(); });
  const Profile temperature = profile(bar, [&](std::size_t p) { return particles.thermal[p].temperature; });
  const std::string label = method.label();
  result.add_curve("pressure, " + label, pressure.x, pressure.y);
  result.add_curve("temperature, " + label, temperature.x, temperature.y);

  const double reached = front_of(pressure, shock.pressure()), expected = end - shock.shock_speed() * t;
  const double wall = end - std::sqrt(2 * shock.energy()) * t, first = expected + 24 * h, last = wall - 12 * h;
  const PlateauRange plateau(pressure, first, last), ringing(pressure, expected, first);
  result.add("plateau, " + label, plateau.mean / shock.pressure() - 1, "mean pressure of the plateau over theory - 1");
  result.add("overshoot, " + label, ringing.largest / shock.pressure() - 1,
             "largest pressure within 24 cells behind the front over theory - 1");
  result.add("speed, " + label, (end - reached) / (end - expected) - 1, "way of the front over theory - 1");
  result.add("temperature, " + label, PlateauRange(temperature, first, last).mean / shock.temperature() - 1,
             "mean temperature of the plateau over theory - 1");
}

void add_theory(const mms::Hugoniot& shock, CheckResult& result) {
  const double t = 4e-6, end = 0.05, front = end - shock.shock_speed() * t,
               wall = end - std::sqrt(2 * shock.energy()) * t;
  const std::vector<double> x{0, front, front, wall};
  result.add_curve("pressure, theory", x, {0, 0, shock.pressure(), shock.pressure()});
  const double at_rest = complete_parameters(find_problem("shock", "the check"), {}).at("temperature");
  result.add_curve("temperature, theory", x, {at_rest, at_rest, shock.temperature(), shock.temperature()});
}

}  // namespace

CheckResult check_shock_profiles() {
  constexpr ShockMethod methods[] = {{"FLIP", "flip", "", true},     {"XPIC(4)", "xpic", "4", true},
                                     {"FMPM(1)", "fmpm", "1", true}, {"FMPM(2)", "fmpm", "2", true},
                                     {"FMPM(4)", "fmpm", "4", true}, {"FLIP", "flip", "", false},
                                     {"FMPM(4)", "fmpm", "4", false}};
  const mms::Hugoniot shock = theoretical_shock();
  CheckResult result;
  add_theory(shock, result);
  for (const ShockMethod& method : methods) add_method(method, shock, result);
  return result;
}

}  // namespace mpmvv
