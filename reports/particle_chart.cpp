#include <algorithm>
#include <cmath>

#include "reports/chart.hpp"

namespace mpmvv::reports {

using records::Point;

namespace {

double value_or(const Point& p, const char* quantity, double absent) {
  const auto it = p.y.find(quantity);
  return it == p.y.end() ? absent : it->second;
}

Box box_of(const Point& p) {
  return {{p.x, value_or(p, "y", NAN)}, value_or(p, "width_x", 0), value_or(p, "width_y", 0)};
}

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

}  // namespace

Chart particle_chart(const records::StudyResult& study, const records::Figure& figure) {
  constexpr double gap = 0.12, few = 300, axes_width = 650;
  Chart chart;
  chart.name = figure.name;
  chart.caption = figure.caption;
  chart.to_scale = true;
  const auto series = figure_series(study, figure);
  Bounds bounds;
  std::size_t most = 0;
  for (const records::Series* s : series) {
    for (const Point& p : s->points) bounds.add(box_of(p));
    most = std::max(most, s->points.size());
  }
  if (most == 0) return chart;

  const double pitch = (1 + gap) * (bounds.right - bounds.left);
  const double size = static_cast<double>(most) > few ? 0.25 : 0.4;
  set_axes(chart, figure, bounds, pitch, series.size());
  for (std::size_t k = 0; k < series.size(); ++k) {
    const double offset = pitch * static_cast<double>(k);
    Curve dots{series[k]->name, "", plain_style, false, true, false, {}, size};
    for (const Point& p : series[k]->points) {
      Box box = box_of(p);
      box.centre.x += offset;
      dots.dots.push_back({box.centre.x, box.centre.y, box.centre.y, Mark::inside});
      if (box.width_x > 0 && box.width_y > 0) chart.boxes.push_back(box);
    }
    chart.curves.push_back(std::move(dots));
    chart.rules.push_back(frame_of(bounds, offset));
    if (series.size() > 1)
      chart.labels.push_back(
          {{(bounds.left + bounds.right) / 2 + offset, chart.y.value(1.06)}, series[k]->name, Label::Side::centre});
  }
  chart.height = std::min(700.0, axes_width * (chart.y.to - chart.y.from) / (chart.x.to - chart.x.from)) + 80;
  if (!chart.boxes.empty())
    chart.notes.push_back("Boxes: the particles' voxels, drawn slightly smaller than they are.");
  return chart;
}

}  // namespace mpmvv::reports
