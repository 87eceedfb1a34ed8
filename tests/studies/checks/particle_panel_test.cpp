#include "studies/checks/profiles/particle_panel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "studies/checks/check.hpp"
#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::checks::particle_panel_test {

/// The largest displacement error over all particles and steps of the run that the pictures are taken from.
double largest_error() {
  std::vector<settings::Setting> settings;
  for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{{"problem", "square"},
                                                                                   {"basis", "cpgimp"},
                                                                                   {"integrator", "cd"},
                                                                                   {"boundary", "symmetry"},
                                                                                   {"cells", "8"},
                                                                                   {"ppc", "2"},
                                                                                   {"cfl", "0.4"},
                                                                                   {"every_step", "true"}})
    settings.push_back({key, value, ""});
  return runs::run_case(settings::make_case(settings), 1).error.linf_all_steps;
}

/// u = 0.1 (sin πX cos 2πt/T, sin πY sin 2πt/T), W (56): the mean over the particles differs from that of the exact
/// positions by no more than the run's largest error.
TEST(ParticlePanel, TheSquaresParticlesFollowItsSolutionAndTheirVoxelsFillIt) {
  const CheckResult result = find_check("square-particles", "").run();
  ASSERT_EQ(result.series.size(), 3U);
  const double error = largest_error();
  ASSERT_LT(error, 0.03);
  double mean_sine = 0;
  for (int i = 0; i < 16; ++i) mean_sine += std::sin(std::numbers::pi * (i + 0.5) / 16) / 16;
  for (int k = 0; k < 3; ++k) {
    const auto& panel = result.series[static_cast<std::size_t>(k)];
    ASSERT_EQ(panel.points.size(), 16U * 16U);
    double x = 0, y = 0, area = 0;
    for (const records::Point& p : panel.points) {
      x += p.x / 256, y += p.y.at("y") / 256;
      area += p.y.at("width_x") * p.y.at("width_y");
      EXPECT_GT(p.x, 0);
      EXPECT_LT(p.x, 1);
    }
    const double phase = 2 * std::numbers::pi * (2 * k + 1) / 8;
    EXPECT_NEAR(x, 0.5 + 0.1 * mean_sine * std::cos(phase), error) << panel.name;
    EXPECT_NEAR(y, 0.5 + 0.1 * mean_sine * std::sin(phase), error) << panel.name;
    EXPECT_NEAR(area, 1, 0.01) << panel.name;
  }
}

/// The vortex whose pictures are shown, in steps that reach the times named: 1/8 and 1/2 are not whole steps of CFL
/// 0.2.
TEST(ParticlePanel, TheVortexsParticlesAreShownAtTheTimesNamed) {
  std::vector<settings::Setting> settings;
  for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{{"problem", "vortex"},
                                                                                   {"basis", "bspline3"},
                                                                                   {"integrator", "cd"},
                                                                                   {"fill", "conforming"},
                                                                                   {"cells", "16"},
                                                                                   {"ppc", "2"},
                                                                                   {"dt", "0.0125"}})
    settings.push_back({key, value, ""});
  profiles::MovingBody<2> motion(settings);
  const CheckResult result = find_check("vortex-particles", "").run();
  ASSERT_EQ(result.series.size(), 3U);
  const std::vector<double> times{0, 1.0 / 8, 1.0 / 2};
  for (std::size_t k = 0; k < times.size(); ++k) {
    motion.step_to(std::lround(times[k] / 0.0125));
    ASSERT_NEAR(motion.mpm().time(), times[k], 1e-12);
    const records::Series expected = profiles::particle_panel("", motion.mpm(), [](std::uint32_t) { return true; });
    ASSERT_EQ(result.series[k].points.size(), expected.points.size());
    for (std::size_t p = 0; p < expected.points.size(); ++p) {
      EXPECT_EQ(result.series[k].points[p].x, expected.points[p].x) << result.series[k].name;
      EXPECT_EQ(result.series[k].points[p].y, expected.points[p].y) << result.series[k].name;
    }
  }
}

}  // namespace mpmvv::checks::particle_panel_test
