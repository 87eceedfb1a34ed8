#include "studies/checks/profiles/shocked_bar.hpp"

namespace mpmvv::checks {

namespace {

/// Returns the mean over the plateau of a ratio: the spacing of neighbouring columns of particles, over their spacing
/// at rest times det F of the particles between them. It is 1 where positions and deformation gradients describe the
/// same motion.
double spacing_over_volume_ratio(const profiles::ShockedBar& bar) {
  const profiles::Profile J =
      profiles::profile(bar.body, [&](std::size_t p) { return bar.body.mpm().thermal_state(p).J; });
  const double column = bar.body.mpm().grid().h() / bar.body.resolution().ppc;
  profiles::Profile ratio;
  for (std::size_t k = 1; k + 1 < J.x.size(); ++k)
    ratio.x.push_back(J.x[k]), ratio.y.push_back((J.x[k + 1] - J.x[k - 1]) / (2 * column * J.y[k]));
  return bar.plateau(ratio).mean;
}

}  // namespace

/// Measures the shock by FMPM(4) at 2.4 µs on five grids: its pressure, its temperature and the ways of its front over
/// those of theory, claim X-shock. x is the number of cells per 2.5 mm.
CheckResult check_shock_grids() {
  const std::vector<double> cells{8, 10, 13, 16, 20};
  const mms::Hugoniot shock = profiles::theoretical_shock();
  std::vector<double> plateau, front, foot, width, temperature, spacing;
  for (const double n : cells) {
    const profiles::ShockedBar bar({"FMPM(4)", "fmpm", "4", true}, static_cast<int>(n), "2.4e-6", shock);
    plateau.push_back(bar.plateau(bar.pressure).mean / shock.pressure());
    temperature.push_back(bar.plateau(bar.temperature).mean / shock.temperature());
    front.push_back(bar.front / bar.expected_front);
    foot.push_back(bar.way_of(0.1) / bar.expected_front);
    width.push_back((bar.way_of(0.25) - bar.way_of(0.75)) / bar.expected_front);
    spacing.push_back(spacing_over_volume_ratio(bar));
  }
  CheckResult result;
  result.add_curve("plateau pressure", cells, plateau);
  result.add_curve("plateau temperature", cells, temperature);
  result.add_curve("way of the front", cells, front);
  result.add_curve("spacing over det F", cells, spacing);
  result.add_curve("way of the foot", cells, foot);
  result.add_curve("width of the front", cells, width);
  return result;
}

}  // namespace mpmvv::checks
