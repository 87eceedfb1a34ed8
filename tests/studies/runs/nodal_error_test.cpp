#include "studies/runs/nodal_error.hpp"

#include <gtest/gtest.h>

#include "mms/bar.hpp"
#include "studies/runs/prepared_case.hpp"
#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::runs::nodal_error_test {

using settings::make_case;
using support::UsageError;

std::vector<settings::Setting> bar_settings(const std::string& boundary) {
  return {{"problem", "bar", ""}, {"basis", "linear", ""}, {"integrator", "usl", ""}, {"boundary", boundary, ""},
          {"cells", "6", ""},     {"ppc", "3", ""},        {"cfl", "0.1", ""},        {"steps", "7", ""}};
}

/// X + u(X, t) = x by bisection.
double reference_position(const mms::Bar& bar, double x, double t) {
  double low = -1, high = 2;
  for (int k = 0; k < 100; ++k) {
    const double X = (low + high) / 2;
    (X + bar.u(mms::Vec<1>(X), t)[0] < x ? low : high) = X;
  }
  return low;
}

/// The norms once more, from the particles alone: hat functions on 6 cells, P F = E/2 (F² - 1), S (50).
ErrorNorms plain_errors(const solver::Particles<1>& particles, const std::vector<solver::Vec<1>>& X, double t,
                        bool periodic) {
  const double E = 1e4, h = 1.0 / 6;
  const mms::Bar bar(0.05, {E, 0, 1});
  ErrorNorms norms;
  for (int i = 0; i < (periodic ? 6 : 7); ++i) {
    double mass = 0, force = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      double r = particles.x[p][0] / h - i;
      if (periodic) r -= 6 * std::round(r / 6);
      if (std::abs(r) >= 1) continue;
      const double N = 1 - std::abs(r), dN = (r < 0 ? 1 : -1) / h, F = particles.F[p](0, 0);
      mass += N * particles.m[p];
      force += N * particles.m[p] * bar.b(X[particles.id[p]], t)[0] - particles.V0[p] * E / 2 * (F * F - 1) * dN;
    }
    const double a = !periodic && i % 6 == 0 ? 0 : force / mass;
    norms.add(std::abs(a - bar.a(mms::Vec<1>(reference_position(bar, i * h, t)), t)[0]));
  }
  return norms;
}

TEST(NodalError, IsThatOfTheAccelerationsAtTheEndTime) {
  for (const bool periodic : {true, false}) {
    const cases::Case c = make_case(bar_settings(periodic ? "periodic" : "dirichlet"));
    auto prepared = prepare_case<1>(c, problems::find_problem("bar", ""), 1);
    solver::Mpm<1> mpm(std::move(prepared.scene));
    for (int k = 0; k < 7; ++k) ASSERT_TRUE(mpm.step(c.resolution.dt));
    const ErrorNorms measured = acceleration_errors(mpm, *prepared.setup.solution, prepared.setup.body);
    const ErrorNorms plain = plain_errors(mpm.particles(), prepared.X, 7 * c.resolution.dt, periodic);
    EXPECT_GT(plain.linf(), 10);  // m/s²
    EXPECT_NEAR(measured.l1(), plain.l1(), 1e-9);
    EXPECT_NEAR(measured.l2(), plain.l2(), 1e-9);
    EXPECT_NEAR(measured.linf(), plain.linf(), 1e-9);
  }
}

TEST(NodalError, IsMeasuredOnlyWhenAskedForAndChangesNothingElse) {
  auto settings = bar_settings("dirichlet");
  const records::Record without = run_case(make_case(settings), 1);
  settings.push_back({"nodal_error", "true", ""});
  const records::Record with = run_case(make_case(settings), 1);
  EXPECT_TRUE(std::isnan(without.error.nodal_l1) && std::isnan(without.error.nodal_linf));
  EXPECT_LT(with.error.nodal_l1, with.error.nodal_l2);
  EXPECT_LT(with.error.nodal_l2, with.error.nodal_linf);
  EXPECT_EQ(with.error.linf, without.error.linf);
  EXPECT_EQ(with.energy.kinetic, without.energy.kinetic);
}

TEST(NodalError, IsRefusedWhereItHasNoMeaning) {
  auto settings = bar_settings("dirichlet");
  settings.push_back({"nodal_error", "true", ""});
  settings.push_back({"wall_acceleration", "difference", ""});
  EXPECT_THROW(make_case(settings), UsageError);
  EXPECT_THROW(make_case(std::vector<settings::Setting>{{"problem", "one-particle", ""},
                                                        {"cells", "1", ""},
                                                        {"ppc", "1", ""},
                                                        {"cfl", "0.1", ""},
                                                        {"nodal_error", "true", ""}}),
               UsageError);
}

TEST(Integrators, StagesHaveNoWallAccelerationByDifference) {
  auto settings = bar_settings("dirichlet");
  settings.push_back({"wall_acceleration", "difference", ""});
  for (const char* integrator : {"usl", "usavg", "usl+", "usavg+", "usf", "cd"}) {
    settings.push_back({"integrator", integrator, ""});
    EXPECT_NO_THROW(make_case(settings)) << integrator;
  }
  for (const char* integrator : {"uvf", "rk4"}) {
    settings.push_back({"integrator", integrator, ""});
    EXPECT_THROW(make_case(settings), UsageError) << integrator;
  }
}

TEST(Integrators, OnlyStaggeredOnesHaveAStart) {
  auto settings = bar_settings("dirichlet");
  settings.push_back({"start", "exact", ""});
  for (const char* integrator : {"usf", "usl", "usavg", "usl+", "usavg+", "rk4"}) {
    settings.push_back({"integrator", integrator, ""});
    EXPECT_THROW(make_case(settings), UsageError) << integrator;
  }
  for (const char* integrator : {"cd", "uvf"}) {
    settings.push_back({"integrator", integrator, ""});
    EXPECT_NO_THROW(make_case(settings)) << integrator;
  }
}

}  // namespace mpmvv::runs::nodal_error_test
