#include <gtest/gtest.h>

#include "studies/runs/prepared_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::runs::mass_cutoff_test {

/// Positions at the end of a run of the square by particle id, and the largest displacement error.
struct Outcome {
  std::vector<solver::Vec<2>> x;
  double error = 0;
};

Outcome run_square(const std::string& basis, const std::string& integrator, double mass_cutoff) {
  const std::vector<settings::Setting> settings{{"problem", "square", ""},
                                                {"basis", basis, ""},
                                                {"integrator", integrator, ""},
                                                {"boundary", "symmetry", ""},
                                                {"cells", "16", ""},
                                                {"ppc", "2", ""},
                                                {"cfl", "0.4", ""}};
  const cases::Case c = settings::make_case(settings);
  auto prepared = prepare_case<2>(c, problems::find_problem("square", ""), 1);
  prepared.scene.mass_cutoff = mass_cutoff;
  solver::Mpm<2> mpm(std::move(prepared.scene));
  for (std::int64_t k = 0; k < c.resolution.steps; ++k) EXPECT_TRUE(mpm.step(c.resolution.dt)) << mpm.fault();
  Outcome outcome;
  const auto& particles = mpm.particles();
  outcome.x.resize(particles.size());
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const solver::Vec<2>& X = prepared.X[particles.id[p]];
    outcome.x[particles.id[p]] = particles.x[p];
    outcome.error = std::max(outcome.error, (particles.x[p] - X - prepared.setup.solution->u(X, mpm.time())).norm());
  }
  return outcome;
}

/// A GIMP particle that overlaps a wall by ε gives the ghost node a mass in ε² and a gradient in ε. Shear stress would
/// accelerate that node as 1/ε, and the velocity gradient with it would depend on the cutoff for any ε. The square's
/// walls carry no shear: there the node's acceleration is bounded, and what the cutoff changes vanishes with ε.
TEST(MassCutoff, DoesNotDecideTheSquare) {
  for (const char* basis : {"cpgimp", "gimp", "linear", "bspline2", "cpdi"})
    for (const char* integrator : {"cd", "usf"}) {
      const Outcome finest = run_square(basis, integrator, 1e-14);
      for (const double cutoff : {1e-12, 1e-10}) {
        const Outcome coarser = run_square(basis, integrator, cutoff);
        double difference = 0;
        for (std::size_t p = 0; p < finest.x.size(); ++p)
          difference = std::max(difference, (finest.x[p] - coarser.x[p]).norm());
        EXPECT_LT(difference, 1e-4 * finest.error) << basis << ' ' << integrator << ' ' << cutoff;
      }
    }
}

}  // namespace mpmvv::runs::mass_cutoff_test
