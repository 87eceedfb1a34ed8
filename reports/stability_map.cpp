#include <fmt/format.h>

#include <algorithm>

#include "reports/axis_label.hpp"
#include "reports/chart.hpp"

namespace mpmvv::reports {

namespace {

std::vector<const records::Series*> probed_series(const records::StudyResult& study, const records::Figure& figure) {
  std::vector<const records::Series*> result;
  for (const auto& s : study.series)
    if (s.limit && (figure.series.empty() || std::ranges::find(figure.series, s.name) != figure.series.end()))
      result.push_back(&s);
  return result;
}

/// The rectangle around the final bracket of a limit.
std::vector<Place> frame(const fits::StabilityLimit& limit, double row) {
  const double low = row - 0.32, high = row + 0.32;
  return {
      {limit.stable, low}, {limit.stable, high}, {limit.unstable, high}, {limit.unstable, low}, {limit.stable, low}};
}

std::string limit_text(const fits::StabilityLimit& limit) {
  const std::string remark = limit.monotone ? "" : ", not monotone";
  if (!limit.found) return "not found" + remark;
  return limit.monotone ? fmt::format("{:#.3g}", limit.value())
                        : fmt::format("{:#.3g} to {:#.3g}{}", limit.stable, limit.unstable, remark);
}

}  // namespace

Chart stability_map(const records::StudyResult& study, const records::Figure& figure) {
  const auto series = probed_series(study, figure);
  Chart chart;
  chart.name = figure.name;
  chart.caption = figure.caption;
  Curve stable{"stable probes", "stable", 0, false, true, false, {}};
  Curve unstable{"unstable probes", "unstable", 1, false, true, false, {}};
  std::vector<double> values;
  const auto rows = static_cast<double>(series.size());
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double row = rows - static_cast<double>(i);
    const auto& limit = *series[i]->limit;
    chart.y.tics.push_back({row, series[i]->name});
    for (const auto& probe : limit.probes) {
      (probe.stable ? stable : unstable)
          .dots.push_back({probe.value, row, row, probe.stable ? Mark::inside : Mark::unstable});
      values.push_back(probe.value);
    }
    if (limit.found)
      chart.rules.push_back({Rule::Kind::limit, plain_style, series[i]->name + ": stability limit", frame(limit, row)});
  }
  const bool log = figure.log_x && !values.empty() && std::ranges::min(values) > 0;
  const std::string key = series.empty() ? study.sweep : series.front()->limit->key;
  chart.x = make_axis(
      {figure.xlabel.empty() ? limit_axis_label(key) : figure.xlabel, log, figure.x_min, figure.x_max, 0.04, 0.04},
      values);
  chart.y.label = figure.ylabel;
  chart.y.from = 0.4;
  chart.y.to = rows + 0.6;
  chart.y.names = true;
  chart.height = 90 + 26 * std::max(1.0, rows);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const std::string text = limit_text(*series[i]->limit);
    chart.labels.push_back({{chart.x.value(1.025), rows - static_cast<double>(i)}, text, Label::Side::left});
    chart.right_margin = std::max(chart.right_margin, text.size() + 2);
  }
  chart.curves = {std::move(stable), std::move(unstable)};
  chart.notes.emplace_back(
      "Every probe of the search, in a frame its final bracket, from where all are stable to where none is. On the "
      "right "
      "its middle, or both ends where a stable probe lies beyond an unstable one.");
  return chart;
}

}  // namespace mpmvv::reports
