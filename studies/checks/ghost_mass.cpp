#include <algorithm>
#include <stdexcept>

#include "studies/check.hpp"
#include "studies/run/scene.hpp"
#include "studies/settings.hpp"

namespace mpmvv {

namespace {

constexpr int cells = 64, ppc = 4;

/// Largest mass on a ghost node in units of a full cell's mass: after the first step and over the whole run.
struct GhostMass {
  double at_rest = 0, deformed = 0, in_motion = 0;
};

double ghost_mass(const solver::Mpm<1>& mpm, double full) {
  const auto& grid = mpm.grid();
  double worst = 0;
  for (int layer = 0; layer < grid.ghost(); ++layer)
    worst = std::max(
        {worst, grid.m(static_cast<std::size_t>(layer)), grid.m(grid.size() - 1 - static_cast<std::size_t>(layer))});
  return worst / full;
}

/// The bar of S §5.2 held at both ends, over half a period; with amplitude 0 it stays at rest.
GhostMass measure(const std::string& basis) {
  GhostMass result;
  for (const char* amplitude : {"0", "0.05"}) {
    const std::vector<Setting> settings{{"problem", "bar", ""},
                                        {"basis", basis, ""},
                                        {"boundary", "dirichlet", ""},
                                        {"integrator", "cd", ""},
                                        {"cells", std::to_string(cells), ""},
                                        {"ppc", std::to_string(ppc), ""},
                                        {"cfl", "0.2", ""},
                                        {"param.amplitude", amplitude, ""}};
    const Case c = make_case(settings);
    auto stage = make_stage<1>(c, find_problem("bar", ""), 1);
    solver::Mpm<1> mpm(std::move(stage.scene));
    for (std::int64_t k = 0; k < c.resolution.steps; ++k) {
      if (!mpm.step(c.resolution.dt)) throw std::runtime_error("ghost-mass: " + mpm.fault());
      const double mass = ghost_mass(mpm, 1.0 / cells);
      if (c.problem.parameters.at("amplitude") == 0) {
        result.at_rest = std::max(result.at_rest, mass);
      } else {
        if (k == 0) result.deformed = mass;
        result.in_motion = std::max(result.in_motion, mass);
      }
    }
  }
  return result;
}

}  // namespace

/// S-ghost, §4.3: mass on ghost nodes of an aligned body.
CheckResult check_ghost_mass() {
  CheckResult result;
  for (const char* basis : {"cpgimp", "gimp", "bspline2", "bspline3"}) {
    const GhostMass mass = measure(basis);
    const std::string name = basis;
    result.add(name + "_at_rest", mass.at_rest, name + ": largest ghost mass of the undeformed bar, in full cells");
    result.add(name + "_deformed", mass.deformed, name + ": largest ghost mass in the bar's first step, in full cells");
    result.add(name + "_in_motion", mass.in_motion, name + ": largest ghost mass over half a period, in full cells");
  }
  return result;
}

}  // namespace mpmvv
