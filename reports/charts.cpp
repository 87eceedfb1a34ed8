#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/chart.hpp"
#include "reports/original_look.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::reports {

using records::Figure;
using records::Series;

std::vector<const Series*> figure_series(const records::StudyResult& study, const Figure& figure) {
  std::vector<const Series*> chosen;
  for (const auto& s : study.series)
    if (figure.series.empty()) chosen.push_back(&s);
  for (const auto& name : figure.series) {
    const auto it = std::ranges::find(study.series, name, &Series::name);
    if (it == study.series.end()) {
      std::vector<std::string> known;
      for (const auto& s : study.series) known.push_back(s.name);
      throw support::UsageError(
          fmt::format("figure '{}' of study '{}' names the series '{}', which the study lacks (it has: {})",
                      figure.name, study.name, name, fmt::join(known, ", ")));
    }
    chosen.push_back(&*it);
  }
  return chosen;
}

std::vector<Chart> charts_of(const records::StudyResult& study, double letter) {
  const auto has_value = [&](const Figure& f) {
    return std::ranges::any_of(study.series, [&](const Series& s) {
      return std::ranges::any_of(s.points, [&](const records::Point& p) { return p.y.contains(f.quantity); });
    });
  };
  const bool limits = study.kind == "limit";
  bool mapped = false;
  std::vector<Chart> charts;
  for (const auto& figure : study.figures) {
    const bool map = limits && !has_value(figure);
    charts.push_back(map                               ? stability_map(study, figure)
                     : figure.kind == "work-precision" ? work_chart(study, figure)
                     : figure.kind == "particles"      ? particle_chart(study, figure)
                                                       : error_chart(study, figure, letter));
    if (!map && figure.kind == "curves") give_original_look(charts.back(), figure);
    mapped |= map;
  }
  const bool probed = std::ranges::any_of(study.series, [](const Series& s) { return s.limit.has_value(); });
  if (limits && probed && !mapped) {
    Figure map;
    map.name = study.name + "-map";
    while (std::ranges::find(study.figures, map.name, &Figure::name) != study.figures.end()) map.name += "-map";
    map.caption = study.title + ": stable and unstable runs of the search for the limit.";
    charts.push_back(stability_map(study, map));
  }
  return charts;
}

}  // namespace mpmvv::reports
