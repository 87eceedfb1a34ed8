#include <algorithm>
#include <cmath>
#include <string>

#include "studies/checks/extremes.hpp"
#include "studies/checks/profiles/profile.hpp"

namespace mpmvv::checks {

namespace {

/// The place of the highest stress and its height, by the parabola through the highest column of particles and its
/// neighbours.
struct Peak {
  double x = 0, height = 0;

  explicit Peak(const profiles::Profile& profile) {
    const auto at = std::max_element(profile.y.begin(), profile.y.end()) - profile.y.begin();
    const auto k = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 1, std::ssize(profile.y) - 2));
    const double width = profile.x[k + 1] - profile.x[k];
    const double slope = (profile.y[k + 1] - profile.y[k - 1]) / 2;
    const double bend = profile.y[k + 1] - 2 * profile.y[k] + profile.y[k - 1];
    x = profile.x[k] - slope / bend * width;
    height = profile.y[k] - slope * slope / (2 * bend);
  }
};

/// Returns the largest |σ| between two places. The caller takes the part where theory has no stress any more: behind
/// the pulse, more than two cells from its end.
double ringing_behind(const profiles::Profile& profile, double from, double to) {
  double largest = 0;
  for (std::size_t k = 0; k < profile.x.size(); ++k)
    if (profile.x[k] >= from && profile.x[k] <= to) keep_larger(largest, std::abs(profile.y[k]));
  return largest;
}

}  // namespace

/// Measures the profiles of N Fig. 6B: σ_xx along the bar at 1.5 ms with cells of 1 mm. The pulse then lies between 50
/// and 150 mm, with its peak at 100 mm.
CheckResult check_pulse_profiles() {
  constexpr double stress = 500, h = 1e-3;
  CheckResult result;
  result.add_curve("theory", {0, 0.05, 0.1, 0.15, 0.2}, {0, 0, stress, 0, 0});
  for (const int order : {0, 1, 2, 4, 8}) {
    std::vector<settings::Setting> settings{{"problem", "pulse", ""},  {"basis", "bspline2", ""},
                                            {"integrator", "usl", ""}, {"deformation", "exponential", ""},
                                            {"cells", "10", ""},       {"ppc", "2", ""},
                                            {"cfl", "0.2", ""}};
    if (order > 0)
      settings.insert(settings.end(), {{"velocity_update", "fmpm", ""}, {"order", std::to_string(order), ""}});
    else
      settings.push_back({"position", "second-order", ""});
    profiles::MovingBody<2> bar(settings, solver::Images::middle);
    bar.step_to(bar.resolution().steps);
    const profiles::Profile sigma = profiles::profile(bar, [&bar](std::size_t p) { return bar.mpm().stress(p)(0, 0); });
    const std::string name = order == 0 ? "FLIP" : "FMPM(" + std::to_string(order) + ")";
    result.add_curve(name, sigma.x, sigma.y);
    const Peak peak(sigma);
    result.add("place, " + name, std::abs(peak.x - 0.1), "distance of the peak from 100 mm (m)");
    result.add("height, " + name, peak.height / stress, "height of the peak over theory");
    result.add("ringing, " + name, ringing_behind(sigma, 0, 0.05 - 2 * h) / stress,
               "largest stress behind the pulse over the peak of theory");
  }
  const auto value = [&result](const std::string& name) {
    return std::find_if(result.values.begin(), result.values.end(),
                        [&](const records::Value& v) { return v.name == name; })
        ->value;
  };
  for (const int order : {2, 4, 8}) {
    const std::string name = ", FMPM(" + std::to_string(order) + ")";
    result.add("place over FLIP" + name, value("place" + name) / value("place, FLIP"),
               "distance of the peak from 100 mm over FLIP's" + name);
    result.add("ringing over FLIP" + name, value("ringing" + name) / value("ringing, FLIP"),
               "largest stress behind the pulse over FLIP's" + name);
  }
  return result;
}

}  // namespace mpmvv::checks
