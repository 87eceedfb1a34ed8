#include <stdexcept>

#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/runs/prepared_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::checks {

namespace {

/// A body that fills its domain, and how it is run.
struct WalledBody {
  const char *problem, *boundary, *amplitude;
  int cells, ppc;
  const char* cfl;
};

/// Largest mass on a ghost node in units of a full cell's mass: at rest, in the first step and over the whole run.
struct GhostMass {
  double at_rest = 0, deformed = 0, in_motion = 0;
};

/// Returns the largest mass on a node beyond a face, an edge or a corner of the domain, divided by h^D.
template <int D>
double ghost_mass(const solver::Grid<D>& grid) {
  double worst = 0;
  for (std::size_t n = 0; n < grid.size(); ++n) {
    const solver::Index<D> i = grid.index(n);
    bool inside = true;
    for (int d = 0; d < D; ++d) inside = inside && i[d] >= 0 && i[d] < grid.inside(d);
    if (!inside) keep_larger(worst, grid.m(n));
  }
  return worst / std::pow(grid.h(), D);
}

/// Runs the body with amplitude 0, with which it stays at rest, and with its own amplitude. As the default density is
/// one, the mass of a full cell is h^D.
template <int D>
GhostMass measure(const WalledBody& body, const std::string& basis) {
  GhostMass result;
  for (const char* amplitude : {"0", body.amplitude}) {
    const std::vector<settings::Setting> settings{{"problem", body.problem, ""},
                                                  {"basis", basis, ""},
                                                  {"boundary", body.boundary, ""},
                                                  {"integrator", "cd", ""},
                                                  {"cells", std::to_string(body.cells), ""},
                                                  {"ppc", std::to_string(body.ppc), ""},
                                                  {"cfl", body.cfl, ""},
                                                  {"param.amplitude", amplitude, ""}};
    const cases::Case c = settings::make_case(settings);
    auto prepared = runs::prepare_case<D>(c, problems::find_problem(body.problem, ""), 1);
    solver::Mpm<D> mpm(std::move(prepared.scene));
    for (std::int64_t k = 0; k < c.resolution.steps; ++k) {
      if (!mpm.step(c.resolution.dt)) throw std::runtime_error("ghost-mass: " + mpm.fault());
      const double mass = ghost_mass(mpm.grid());
      if (c.problem.parameters.at("amplitude") == 0) {
        keep_larger(result.at_rest, mass);
      } else {
        if (k == 0) result.deformed = mass;
        keep_larger(result.in_motion, mass);
      }
    }
  }
  return result;
}

template <int D>
void add(CheckResult& result, const WalledBody& body, const std::string& basis, const std::string& name) {
  const GhostMass mass = measure<D>(body, basis);
  const std::string who = basis + " on the " + body.problem;
  result.add(name + "_at_rest", mass.at_rest, who + ": largest ghost mass of the undeformed body, in full cells");
  result.add(name + "_deformed", mass.deformed, who + ": largest ghost mass in the first step, in full cells");
  result.add(name + "_in_motion", mass.in_motion, who + ": largest ghost mass over the run, in full cells");
}

}  // namespace

/// Measures the mass on ghost nodes of an aligned body, claim S-ghost, S §4.3.
CheckResult check_ghost_mass() {
  const WalledBody bar{"bar", "dirichlet", "0.05", 64, 4, "0.2"};
  const WalledBody square{"square", "symmetry", "0.1", 32, 2, "0.4"};
  const WalledBody cube{"cube", "symmetry", "0.05", 16, 2, "0.4"};
  CheckResult result;
  for (const std::string basis : {"cpgimp", "gimp", "bspline2", "bspline3"}) add<1>(result, bar, basis, basis);
  for (const std::string basis : {"cpgimp", "bspline2"}) {
    add<2>(result, square, basis, "square_" + basis);
    add<3>(result, cube, basis, "cube_" + basis);
  }
  return result;
}

}  // namespace mpmvv::checks
