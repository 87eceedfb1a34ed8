#pragma once
#include <string>
#include <vector>

#include "reports/chart.hpp"

namespace mpmvv::reports {

/// Particles that are drawn in one panel: as dots with their voxels, where these have a width, or as squares of that
/// width in shades.
struct Panel {
  std::string name;
  std::vector<Box> particles;
  std::vector<double> shades = {};  ///< one of each particle, or none
};

/// A chart with the panels side by side, to scale, a curve for each. `axes_width` is in pixels. Without any particle it
/// has no curves.
Chart panel_chart(const records::Figure& figure, const std::vector<Panel>& panels, double axes_width);

}  // namespace mpmvv::reports
