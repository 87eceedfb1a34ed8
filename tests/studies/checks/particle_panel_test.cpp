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

}  // namespace mpmvv::checks::particle_panel_test
