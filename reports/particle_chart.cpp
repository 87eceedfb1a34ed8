#include <cmath>

#include "reports/panels.hpp"

namespace mpmvv::reports {

using records::Point;

namespace {

double value_or(const Point& p, const char* quantity, double absent) {
  const auto it = p.y.find(quantity);
  return it == p.y.end() ? absent : it->second;
}

}  // namespace

Chart particle_chart(const records::StudyResult& study, const records::Figure& figure) {
  constexpr double axes_width = 650;
  std::vector<Panel> panels;
  for (const records::Series* series : figure_series(study, figure)) {
    panels.push_back({series->name, {}});
    for (const Point& p : series->points)
      panels.back().particles.push_back(
          {{p.x, value_or(p, "y", NAN)}, value_or(p, "width_x", 0), value_or(p, "width_y", 0)});
  }
  Chart chart = panel_chart(figure, panels, axes_width);
  if (!chart.boxes.empty())
    chart.notes.emplace_back("Boxes: the particles' voxels, drawn slightly smaller than they are.");
  return chart;
}

}  // namespace mpmvv::reports
