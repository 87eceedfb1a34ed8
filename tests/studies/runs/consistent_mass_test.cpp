#include <gtest/gtest.h>

#include "studies/runs/prepared_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::runs::consistent_mass_test {

using solver::ConsistentMassSettings;
using Positions = std::vector<solver::Vec<2>>;

/// Positions at the end of a run of the square by particle id; `exact` the solution's.
Positions run_square(const std::string& basis, const std::optional<ConsistentMassSettings>& mass,
                     Positions* exact = nullptr) {
  const std::vector<settings::Setting> settings{
      {"problem", "square", ""}, {"basis", basis, ""}, {"integrator", "cd", ""}, {"boundary", "symmetry", ""},
      {"cells", "8", ""},        {"ppc", "2", ""},     {"cfl", "0.2", ""}};
  const cases::Case c = settings::make_case(settings);
  auto prepared = prepare_case<2>(c, problems::find_problem("square", ""), 1);
  prepared.scene.consistent_mass = mass;
  solver::Mpm<2> mpm(std::move(prepared.scene));
  for (std::int64_t k = 0; k < c.resolution.steps; ++k) EXPECT_TRUE(mpm.step(c.resolution.dt)) << mpm.fault();
  const auto& particles = mpm.particles();
  Positions x(particles.size());
  for (std::size_t p = 0; p < x.size(); ++p) x[particles.id[p]] = particles.x[p];
  if (exact)
    for (const auto& X : prepared.X) exact->emplace_back(X + prepared.setup.solution->u(X, mpm.time()));
  return x;
}

double largest_distance(const Positions& a, const Positions& b) {
  double largest = 0;
  for (std::size_t p = 0; p < a.size(); ++p) largest = std::max(largest, (a[p] - b[p]).norm());
  return largest;
}

/// The consistent mass removes most of what the lumped one errs by. How it is kept from being singular decides a few
/// per cent of that, over decades.
TEST(ConsistentMass, ItsRegularisationDoesNotDecideTheSquare) {
  for (const char* basis : {"bspline2", "bspline3", "cpgimp"}) {
    Positions exact;
    const double lumped_error = largest_distance(run_square(basis, {}, &exact), exact);
    const Positions chosen = run_square(basis, ConsistentMassSettings{});
    EXPECT_LT(largest_distance(chosen, exact), 0.25 * lumped_error) << basis;
    for (const double lumped_share : {1e-3, 1e-4, 1e-5})
      EXPECT_LT(largest_distance(run_square(basis, ConsistentMassSettings{.lumped_share = lumped_share}), chosen),
                0.04 * lumped_error)
          << basis << ' ' << lumped_share;
    for (const double covered : {0.1, 0.5})
      EXPECT_LT(largest_distance(run_square(basis, ConsistentMassSettings{.covered = covered}), chosen),
                0.04 * lumped_error)
          << basis << ' ' << covered;
    for (const double tolerance : {1e-4, 1e-7, 1e-10})
      EXPECT_LT(largest_distance(run_square(basis, ConsistentMassSettings{.tolerance = tolerance}), chosen),
                1e-4 * lumped_error)
          << basis << ' ' << tolerance;
  }
}

}  // namespace mpmvv::runs::consistent_mass_test
