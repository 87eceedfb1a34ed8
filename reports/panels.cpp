#include "reports/panels.hpp"

#include <algorithm>
#include <cmath>

namespace mpmvv::reports {

namespace {

/// The smallest rectangle, with sides along the axes, that holds all particles and voxels.
struct Bounds {
  double left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;

  void add(const Box& b) {
    left = std::min(left, b.centre.x - b.width_x / 2), right = std::max(right, b.centre.x + b.width_x / 2);
    bottom = std::min(bottom, b.centre.y - b.width_y / 2), top = std::max(top, b.centre.y + b.width_y / 2);
  }
};

/// The axes hold all panels; each panel has its own tics.
void set_axes(Chart& chart, const records::Figure& figure, const Bounds& bounds, double pitch, std::size_t panels) {
  const double margin = 0.03 * (bounds.top - bounds.bottom);
  const std::vector<double> across{bounds.left - margin, bounds.right + margin}, up{bounds.bottom, bounds.top};
  chart.x = make_axis({figure.xlabel, false, {}, {}}, across);
  chart.y = make_axis({figure.ylabel, false, bounds.bottom - margin, bounds.top + margin}, up);
  const auto tics = std::move(chart.x.tics);
  chart.x.tics.clear();
  for (std::size_t k = 0; k < panels; ++k)
    for (const Tic& tic : tics)
      if (chart.x.holds(tic.at)) chart.x.tics.push_back({tic.at + pitch * static_cast<double>(k), tic.text});
  chart.x.from = bounds.left - margin;
  chart.x.to = bounds.right + margin + pitch * static_cast<double>(panels - 1);
}

Rule frame_of(const Bounds& b, double offset) {
  const double left = b.left + offset, right = b.right + offset;
  return {Rule::Kind::frame,
          plain_style,
          "smallest rectangle around all panels' particles",
          {{left, b.bottom}, {right, b.bottom}, {right, b.top}, {left, b.top}, {left, b.bottom}}};
}

Curve curve_of(const Panel& panel, double offset, double size) {
  Curve dots{panel.name, "", plain_style, false, true, false, {}, size};
  if (!panel.shades.empty()) dots.square = panel.particles.front().width_x;
  for (std::size_t p = 0; p < panel.particles.size(); ++p) {
    const auto [x, y] = panel.particles[p].centre;
    dots.dots.push_back({x + offset, y, y, Mark::inside});
    if (!panel.shades.empty()) dots.dots.back().shade = panel.shades[p];
  }
  return dots;
}

void add_voxels(Chart& chart, const Panel& panel, double offset) {
  for (const auto& [centre, width_x, width_y] : panel.particles)
    if (width_x > 0 && width_y > 0) chart.boxes.push_back({{centre.x + offset, centre.y}, width_x, width_y});
}

}  // namespace

Chart panel_chart(const records::Figure& figure, const std::vector<Panel>& panels, double axes_width) {
  constexpr double gap = 0.12, few = 300;
  Chart chart;
  chart.name = figure.name;
  chart.caption = figure.caption;
  chart.to_scale = chart.of_particles = true;
  Bounds bounds;
  std::size_t most = 0;
  for (const Panel& panel : panels) {
    for (const Box& box : panel.particles) bounds.add(box);
    most = std::max(most, panel.particles.size());
  }
  if (most == 0) return chart;

  const double pitch = (1 + gap) * (bounds.right - bounds.left);
  const double size = static_cast<double>(most) > few ? 0.25 : 0.4;
  set_axes(chart, figure, bounds, pitch, panels.size());
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const double offset = pitch * static_cast<double>(k);
    chart.curves.push_back(curve_of(panels[k], offset, size));
    if (panels[k].shades.empty()) add_voxels(chart, panels[k], offset);
    chart.rules.push_back(frame_of(bounds, offset));
    if (panels.size() > 1)
      chart.labels.push_back(
          {{(bounds.left + bounds.right) / 2 + offset, chart.y.value(1.06)}, panels[k].name, Label::Side::centre});
  }
  chart.height = std::min(700.0, axes_width * (chart.y.to - chart.y.from) / (chart.x.to - chart.x.from)) + 80;
  return chart;
}

}  // namespace mpmvv::reports
