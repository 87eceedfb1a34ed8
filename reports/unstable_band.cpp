#include "reports/unstable_band.hpp"

#include <algorithm>
#include <map>
#include <ranges>
#include <utility>
#include <vector>

namespace mpmvv::reports {

namespace {

constexpr double line = 1.2;  ///< from a tic's text to the next, in heights of a letter

/// The least height of a band, as a fraction of the axis without it, whose name is clear of the uppermost tic's text.
double least_height(const Axis& axis, double letter) {
  double top = 0;
  for (const Tic& tic : axis.tics)
    if (!tic.text.empty()) top = std::max(top, axis.fraction(tic.at));
  return (line * letter - (1 - top)) / (0.5 - line * letter);
}

}  // namespace

void add_band(Axis& axis, double band, double letter) {
  axis.to = axis.value(1 / (1 - band));
  const double middle = 1 - band / 2;
  for (Tic& tic : axis.tics)
    if (axis.fraction(tic.at) > middle - 0.99 * line * letter) tic.text.clear();
  axis.tics.push_back({axis.value(middle), "unstable"});
}

void add_unstable_band(Chart& chart, double row) {
  std::map<double, int> at_x;
  std::vector<std::pair<Dot*, int>> crosses;
  for (Curve& curve : chart.curves)
    for (Dot& dot : curve.dots)
      if (dot.mark == Mark::unstable && chart.x.holds(dot.x)) crosses.emplace_back(&dot, at_x[dot.x]++);
  if (crosses.empty()) return;
  const int rows = std::ranges::max(at_x | std::views::values);
  const double height = std::max(row * (rows + 1), least_height(chart.y, chart.letter));
  chart.band = height / (1 + height);
  chart.top_of_values = chart.y.to;
  add_band(chart.y, chart.band, chart.letter);
  for (const auto& [dot, place] : crosses) dot->drawn = chart.y.value(1 - chart.band * (place + 1) / (rows + 1));
}

double top_of_values(const Chart& chart) {
  return chart.band > 0 ? chart.top_of_values : chart.y.to;
}

bool holds(const Chart& chart, const Dot& dot) {
  const bool is_cross = chart.band > 0 && dot.mark == Mark::unstable;
  return chart.x.holds(dot.x) && chart.y.holds(dot.drawn) && (is_cross || dot.drawn <= top_of_values(chart));
}

}  // namespace mpmvv::reports
