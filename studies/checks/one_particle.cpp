#include <cmath>
#include <stdexcept>

#include "studies/checks/check.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/runs/prepared_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::checks {

namespace {

/// The particle of W §3 in one cell of width h: position, velocity, deformation gradient.
struct OneParticle {
  double x, v, F;
};

struct Constants {
  double E, h, V0, m, sign;  ///< sign -1 as W (14) has it, +1 as W (27) is printed
};

/// Returns the state after a step of USF, W (34) to (36).
OneParticle usf_step(const OneParticle& s, const Constants& c, double dt) {
  const double F = (1 + s.v / c.h * dt) * s.F;
  const double kick = c.sign * c.E / (2 * c.h) * (F * F - 1) * (c.V0 / c.m) * dt;
  return {s.x + s.v * (s.x / c.h) * dt + kick * dt, s.v + kick, F};
}

/// Returns the state after a step of USL, W (37) to (39).
OneParticle usl_step(const OneParticle& s, const Constants& c, double dt) {
  const double force = c.sign * c.E / 2 * (s.F * s.F - 1) * c.V0;
  const double kick = force / (c.h * c.m) * dt;
  return {s.x + s.v * (s.x / c.h) * dt + kick * dt, s.v + kick,
          (1 + (s.v / c.h + force / (c.m * s.x * c.h) * dt) * dt) * s.F};
}

struct Comparison {
  double difference = 0, largest_stretch = 0, printed_stretch = 0;
  std::vector<double> steps, solver_F, recursion_F, printed_F;
};

/// Runs the solver beside the recursion over some three oscillations (20 h/C).
Comparison compare(const std::string& integrator,
                   OneParticle (*advance)(const OneParticle&, const Constants&, double)) {
  const std::vector<settings::Setting> settings{{"problem", "one-particle", ""},
                                                {"basis", "linear", ""},
                                                {"integrator", integrator, ""},
                                                {"cells", "1", ""},
                                                {"ppc", "1", ""},
                                                {"cfl", "0.02", ""},
                                                {"end_time", "0.2", ""}};
  const cases::Case c = settings::make_case(settings);
  auto prepared = runs::prepare_case<1>(c, problems::find_problem("one-particle", ""), 1);
  const auto& start = prepared.scene.particles;
  const Constants constants{c.problem.parameters.at("youngs_modulus"), prepared.scene.h, start.V0[0], start.m[0], -1};
  Constants printed = constants;
  printed.sign = 1;
  OneParticle recursion{start.x[0][0], start.v[0][0], start.F[0](0, 0)};
  OneParticle wrong = recursion;
  solver::Mpm<1> mpm(std::move(prepared.scene));
  Comparison result;
  for (std::int64_t k = 0; k < c.resolution.steps; ++k) {
    if (!mpm.step(c.resolution.dt)) throw std::runtime_error("one-particle: " + mpm.fault());
    recursion = advance(recursion, constants, c.resolution.dt);
    if (wrong.F < 10) wrong = advance(wrong, printed, c.resolution.dt);
    const auto& p = mpm.particles();
    const double scale_v = std::abs(c.problem.parameters.at("velocity"));
    keep_larger(result.difference, std::abs(p.x[0][0] - recursion.x));
    keep_larger(result.difference, std::abs(p.v[0][0] - recursion.v) / scale_v);
    keep_larger(result.difference, std::abs(p.F[0](0, 0) - recursion.F));
    keep_larger(result.largest_stretch, recursion.F);
    keep_larger(result.printed_stretch, wrong.F);
    result.steps.push_back(static_cast<double>(k + 1));
    result.solver_F.push_back(p.F[0](0, 0));
    result.recursion_F.push_back(recursion.F);
    result.printed_F.push_back(wrong.F < 2 ? wrong.F : support::not_measured);
  }
  return result;
}

}  // namespace

/// Compares the solver with the recursions of W §3 with the sign of W (14), claim W-one.
CheckResult check_one_particle() {
  CheckResult result;
  for (const auto& [name, advance] : {std::pair{"usf", &usf_step}, std::pair{"usl", &usl_step}}) {
    const Comparison c = compare(name, advance);
    const std::string prefix = name;
    result.add(prefix + "_difference", c.difference,
               prefix + ": largest difference of x/h, v/v0 and F to the recursion");
    result.add(prefix + "_stretch", c.largest_stretch, prefix + ": largest F of the recursion with the sign of W (14)");
    result.add(prefix + "_printed_stretch", c.printed_stretch,
               prefix + ": largest F of the recursion as printed (stopped at 10)");
    result.add_curve(prefix + ", solver", c.steps, c.solver_F);
    result.add_curve(prefix + ", recursion", c.steps, c.recursion_F);
    result.add_curve(prefix + ", recursion as printed", c.steps, c.printed_F);
  }
  return result;
}

}  // namespace mpmvv::checks
