#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "mms/hugoniot.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/checks/profiles/profile.hpp"

namespace mpmvv::checks::profiles {

/// A velocity update of N Fig. 8, with or without artificial viscosity, and with N's walls or with held nodes
/// eliminated.
struct ShockMethod {
  const char *name, *update, *order;
  bool viscous;
  bool eliminates = false;

  std::string label() const {
    return std::string(name) + (viscous ? "" : ", no artificial viscosity") + (eliminates ? ", elimination" : "");
  }

  /// Returns the settings of a run with `cells` cells per 2.5 mm and the end time in s.
  std::vector<settings::Setting> settings(int cells, const char* end_time) const {
    std::vector<settings::Setting> all{{"problem", "shock", ""},
                                       {"basis", "b2cpdi", ""},
                                       {"integrator", "usl", ""},
                                       {"deformation", "exponential", ""},
                                       {"velocity_update", update, ""},
                                       {"wall_depth", "1.5", ""},
                                       {"wall_gradient", "estimated", ""},
                                       {"cells", std::to_string(cells), ""},
                                       {"ppc", "2", ""},
                                       {"end_time", end_time, ""},
                                       {"cfl", "0.2", ""}};
    if (*order)
      all.push_back({"order", order, ""});
    else
      all.push_back({"position", "second-order", ""});
    if (eliminates) all.push_back({"wall_method", "elimination", ""});
    if (!viscous)
      for (const char* key : {"param.linear_viscosity", "param.quadratic_viscosity"}) all.push_back({key, "0", ""});
    return all;
  }
};

/// Returns the theoretical shock for the default parameters of the problem `shock`.
inline mms::Hugoniot theoretical_shock() {
  const problems::Parameters p = problems::complete_parameters(problems::find_problem("shock", "the check"), {});
  return {{p.at("bulk_modulus"), p.at("density"), p.at("hugoniot_slope"), p.at("gamma"), p.at("heat_capacity"),
           p.at("temperature")},
          p.at("velocity")};
}

/// Returns the first place, from the left, where the profile rises through `level`; its last place where it does not.
inline double rise_through(const Profile& profile, double level) {
  for (std::size_t k = 1; k < profile.x.size(); ++k) {
    const double before = profile.y[k - 1], after = profile.y[k];
    if (after >= level)
      return profile.x[k - 1] + (profile.x[k] - profile.x[k - 1]) * (level - before) / (after - before);
  }
  return profile.x.back();
}

/// The mean and the largest of the values of a profile between two places.
struct PlateauRange {
  double mean = 0, largest = 0;

  PlateauRange(const Profile& profile, double from, double to) {
    double count = 0;
    for (std::size_t k = 0; k < profile.x.size(); ++k)
      if (profile.x[k] >= from && profile.x[k] <= to) mean += profile.y[k], ++count, keep_larger(largest, profile.y[k]);
    mean /= count;
  }
};

/// A bar under shock and what is measured on it. The plateau reaches from 24 cells behind the theoretical front to 12
/// cells before the wall. The ringing is measured in the 24 cells behind that front.
struct ShockedBar {
  static constexpr double end = 0.05;  ///< the place where the driving wall starts, m

  MovingBody<2> body;
  Profile pressure, temperature;
  double plateau_pressure;                    ///< the pressure of the plateau by theory, Pa
  double front, expected_front, first, last;  ///< ways of the front, measured and by theory, and ends of the plateau, m

  ShockedBar(const ShockMethod& method, int cells, const char* end_time, const mms::Hugoniot& shock)
      : body(method.settings(cells, end_time), solver::Images::middle), plateau_pressure(shock.pressure()) {
    body.step_to(body.resolution().steps);
    const double h = body.mpm().grid().h(), t = body.mpm().time();
    pressure = profile(body, [&](std::size_t p) { return body.mpm().thermal_state(p).total_pressure(); });
    temperature = profile(body, [&](std::size_t p) { return body.mpm().thermal_state(p).temperature; });
    front = way_of(0.5);
    expected_front = shock.shock_speed() * t;
    first = end - expected_front + 24 * h;
    last = end - std::sqrt(2 * shock.energy()) * t - 12 * h;
  }

  /// Returns how far from the start of the driving wall the pressure rises through this share of the plateau's, m.
  double way_of(double share) const { return end - rise_through(pressure, share * plateau_pressure); }

  PlateauRange plateau(const Profile& profile) const { return {profile, first, last}; }
  PlateauRange ringing() const { return {pressure, end - expected_front, first}; }
};

}  // namespace mpmvv::checks::profiles
