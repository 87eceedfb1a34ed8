#include <algorithm>

#include "reports/chart.hpp"

namespace mpmvv {

std::vector<Chart> charts_of(const StudyResult& study) {
  const auto has_value = [&](const Figure& f) {
    return std::ranges::any_of(study.series, [&](const Series& s) {
      return std::ranges::any_of(s.points, [&](const Point& p) { return p.y.contains(f.quantity); });
    });
  };
  const bool limits = study.kind == "limit";
  bool mapped = false;
  std::vector<Chart> charts;
  for (const auto& figure : study.figures) {
    const bool map = limits && !has_value(figure);
    charts.push_back(map ? stability_map(study, figure) : error_chart(study, figure));
    mapped |= map;
  }
  const bool probed = std::ranges::any_of(study.series, [](const Series& s) { return s.limit.has_value(); });
  if (limits && probed && !mapped) {
    Figure map;
    map.name = study.name + "-map";
    map.caption = "Stability map: " + study.title;
    charts.push_back(stability_map(study, map));
  }
  return charts;
}

}  // namespace mpmvv
