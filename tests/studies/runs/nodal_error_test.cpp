#include "studies/runs/nodal_error.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <stdexcept>
#include <utility>

#include "mms/bar.hpp"
#include "mms/derived.hpp"
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

/// The norms once more, from the particles alone: hat functions on 6 cells, P F = E/2 (F² - 1), S (50). The grid is
/// moved down by `offset` cells.
ErrorNorms plain_errors(const solver::Particles<1>& particles, const std::vector<solver::Vec<1>>& X, double t,
                        bool periodic, double offset) {
  const double E = 1e4, h = 1.0 / 6;
  const mms::Bar bar(0.05, {E, 0, 1});
  ErrorNorms norms;
  for (int i = 0; i < (periodic ? 6 : 7); ++i) {
    const double node = i - offset;
    double mass = 0, force = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      double r = particles.x[p][0] / h - node;
      if (periodic) r -= 6 * std::round(r / 6);
      if (std::abs(r) >= 1) continue;
      const double N = 1 - std::abs(r), dN = (r < 0 ? 1 : -1) / h, F = particles.F[p](0, 0);
      mass += N * particles.m[p];
      force += N * particles.m[p] * bar.b(X[particles.id[p]], t)[0] - particles.V0[p] * E / 2 * (F * F - 1) * dN;
    }
    const double a = !periodic && i % 6 == 0 ? 0 : force / mass;
    norms.add(std::abs(a - bar.a(mms::Vec<1>(reference_position(bar, node * h, t)), t)[0]));
  }
  return norms;
}

/// The bar after seven steps.
struct MovedBar {
  PreparedCase<1> prepared;
  solver::Mpm<1> mpm;

  MovedBar(const std::string& boundary, double offset) : MovedBar(made(boundary, offset)) {}
  explicit MovedBar(const cases::Case& c)
      : prepared(prepare_case<1>(c, problems::find_problem("bar", ""), 1)), mpm(std::move(prepared.scene)) {
    mpm.advance(c.resolution.dt, 7);
  }

  ErrorNorms errors(const mms::ManufacturedSolution<1>& solution) {
    return acceleration_errors(mpm, solution, prepared.setup.body);
  }

 private:
  static cases::Case made(const std::string& boundary, double offset) {
    auto settings = bar_settings(boundary);
    settings.push_back({"grid_offset", fmt::format("{}", offset), ""});
    return make_case(settings);
  }
};

void expect_near(const ErrorNorms& measured, const ErrorNorms& wanted, double tolerance) {
  EXPECT_NEAR(measured.l1(), wanted.l1(), tolerance);
  EXPECT_NEAR(measured.l2(), wanted.l2(), tolerance);
  EXPECT_NEAR(measured.linf(), wanted.linf(), tolerance);
}

TEST(NodalError, IsThatOfTheAccelerationsAtTheEndTime) {
  for (const auto& [boundary, offset] : {std::pair{"periodic", 0.0}, {"periodic", 0.25}, {"dirichlet", 0.0}}) {
    MovedBar bar(boundary, offset);
    const ErrorNorms plain =
        plain_errors(bar.mpm.particles(), bar.prepared.X, bar.mpm.time(), bar.mpm.periodic()[0], offset);
    EXPECT_GT(plain.linf(), 10);  // m/s²
    expect_near(bar.errors(*bar.prepared.setup.solution), plain, 1e-9);
  }
}

/// The bar, carried a way along its periodic grid.
struct CarriedBar {
  mms::BarDisplacement bar;
  double way;

  template <class T>
  std::array<T, 1> operator()(const std::array<T, 1>& X, const T& t) const {
    return {bar(X, t)[0] + way};
  }
};

TEST(NodalError, CountsTheNodesOfABodyThatHasGoneRound) {
  MovedBar bar("periodic", 0);
  const ErrorNorms at_home = bar.errors(*bar.prepared.setup.solution);
  for (const double way : {3.0, -2.0}) {
    const auto carried = mms::derived<1>(CarriedBar{{0.05, 100}, way}, mms::Elasticity{1e4, 0, 1}, 0.05);
    expect_near(bar.errors(carried), at_home, 1e-8);
  }
}

TEST(NodalError, OfNoNodesIsNoNumber) {
  for (const double norm : {ErrorNorms().l1(), ErrorNorms().l2(), ErrorNorms().linf()}) EXPECT_TRUE(std::isnan(norm));
}

/// A particle has just left: no step has found it yet.
TEST(NodalError, IsNotThatOfAGridToWhichNotAllParticlesAreMapped) {
  auto settings = bar_settings("free");
  for (const auto& [key, value] : {std::pair{"problem", "translation"},
                                   {"basis", "bspline2"},
                                   {"cells", "8"},
                                   {"ppc", "2"},
                                   {"cfl", "0.2"},
                                   {"steps", "25"}})
    settings.push_back({key, value, ""});
  const cases::Case c = make_case(settings);
  PreparedCase<2> prepared = prepare_case<2>(c, problems::find_problem("translation", ""), 1);
  solver::Mpm<2> mpm(std::move(prepared.scene));
  EXPECT_EQ(mpm.advance(c.resolution.dt, 25), 25);
  EXPECT_EQ(mpm.fault(), "");
  EXPECT_THAT([&] { acceleration_errors(mpm, *prepared.setup.solution, prepared.setup.body); },
              testing::ThrowsMessage<std::runtime_error>("a particle left the domain"));
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
  settings = bar_settings("symmetry");
  for (const settings::Setting& more : std::vector<settings::Setting>{
           {"velocity_update", "fmpm", ""}, {"order", "2", ""}, {"wall_method", "velocity", ""}})
    settings.push_back(more);
  EXPECT_NO_THROW(make_case(settings));
  settings.push_back({"nodal_error", "true", ""});
  EXPECT_THAT([&] { make_case(settings); },
              testing::ThrowsMessage<UsageError>(testing::HasSubstr("nodal_error with wall_method 'velocity'")));
  settings.push_back({"wall_method", "lumped", ""});
  EXPECT_NO_THROW(make_case(settings));
  std::vector<settings::Setting> swing{
      {"problem", "swing", ""}, {"cells", "8", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}};
  EXPECT_NO_THROW(make_case(swing));
  swing.push_back({"nodal_error", "true", ""});
  EXPECT_THAT([&] { make_case(swing); }, testing::ThrowsMessage<UsageError>(testing::HasSubstr("boundary 'wall'")));
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
