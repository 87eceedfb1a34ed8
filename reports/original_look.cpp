#include "reports/original_look.hpp"

#include <algorithm>
#include <map>

#include "reports/papers.hpp"
#include "reports/unstable_band.hpp"

namespace mpmvv::reports {

namespace {

/// The axis of the original where it has the figure's quantity in another unit; else null.
const OriginalAxis* upwards_axis(const records::Figure& figure) {
  for (const Paper& paper : papers())
    for (const PaperFigure& original : paper.figures)
      if (std::ranges::find(original.panels, figure.name) != original.panels.end() && original.upwards &&
          original.upwards->quantity == figure.quantity)
        return &*original.upwards;
  return nullptr;
}

void scale_y(Chart& chart, double factor, const std::string& label) {
  for (Curve& curve : chart.curves)
    for (Dot& dot : curve.dots) dot.value *= factor, dot.drawn *= factor;
  for (Rule& rule : chart.rules)
    for (Place& place : rule.path) place.y *= factor;
  for (Label& text : chart.labels) text.at.y *= factor;
  chart.y = make_axis({label, chart.y.log, chart.y.from * factor, top_of_values(chart) * factor}, {});
  chart.top_of_values *= factor;
  if (chart.band > 0) add_band(chart.y, chart.band, chart.letter);
}

void draw_to_scale(Chart& chart) {
  constexpr double axes_width = 650, room_for_labels = 80;
  chart.to_scale = true;
  chart.height = axes_width * (chart.y.to - chart.y.from) / (chart.x.to - chart.x.from) + room_for_labels;
}

/// Curves that no group names follow the groups, each as one of its own.
void group(Chart& chart, const std::vector<std::vector<std::string>>& groups) {
  std::map<int, Style> styles;
  int next = static_cast<int>(groups.size());
  for (Curve& curve : chart.curves) {
    const auto has_curve = [&](const auto& names) { return std::ranges::find(names, curve.name) != names.end(); };
    const auto own = std::ranges::find_if(groups, has_curve);
    const Style look = own == groups.end()
                           ? Style(next++, 0)
                           : Style(static_cast<int>(own - groups.begin()),
                                   static_cast<int>(std::ranges::find(*own, curve.name) - own->begin()));
    styles.emplace(curve.style.number, look);
    curve.style = look;
  }
  for (Rule& rule : chart.rules)
    if (const auto look = styles.find(rule.style.number); rule.style != plain_style && look != styles.end())
      rule.style = look->second;
}

}  // namespace

double upwards_factor(const records::Figure& figure) {
  const OriginalAxis* axis = upwards_axis(figure);
  return axis ? axis->factor : 1;
}

void give_original_look(Chart& chart, const records::Figure& figure) {
  if (const OriginalAxis* axis = upwards_axis(figure)) scale_y(chart, axis->factor, axis->label);
  for (const Paper& paper : papers())
    for (const PaperFigure& original : paper.figures) {
      if (std::ranges::find(original.panels, figure.name) == original.panels.end()) continue;
      if (original.to_scale && !chart.x.log && !chart.y.log) draw_to_scale(chart);
      if (!original.groups.empty()) group(chart, original.groups);
    }
}

}  // namespace mpmvv::reports
