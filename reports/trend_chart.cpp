#include "reports/trend_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "reports/axis_label.hpp"
#include "reports/unstable_band.hpp"

namespace mpmvv::reports {

using claims::Finding;
using claims::Trend;

namespace {

constexpr std::size_t most_commits = 7;         ///< as texts below the axis
constexpr std::size_t most_markers_drawn = 25;  ///< on a curve
constexpr std::size_t version_letters = 12;     ///< of what another code says of its version

/// What the trends of one figure have in common: a figure has one axis.
struct Shown {
  Finding::Kind kind;
  std::string quantity;  ///< of errors and limits
  bool operator==(const Shown&) const = default;
};

Shown shown_in(const Trend& trend) {
  return {trend.kind, trend.quantity};
}

/// What stands behind the study in the name of the file.
std::string file_part(const Shown& shown) {
  const std::string kind = to_string(shown.kind) + "s";
  return shown.quantity.empty() ? kind : kind + "-" + shown.quantity;
}

std::string axis_label_of(const Shown& shown) {
  if (shown.kind == Finding::Kind::order) return "observed order";
  if (shown.kind == Finding::Kind::error) return error_axis_label(shown.quantity);
  return shown.quantity.empty() ? "stability limit"
                                : fmt::format("stability limit ({})", limit_axis_label(shown.quantity));
}

/// A commit, or what another code says of its version; its digest where that would read the same for several.
std::string name_of(const store::Version& version, const History& history) {
  const auto shown = [&](const store::Version& v) {
    const std::string text = store::in_short(v.commits.front());
    return history.code.empty() ? text : text.substr(0, version_letters);
  };
  const bool is_unique = std::ranges::count(history.versions, shown(version), shown) == 1;
  return is_unique ? shown(version) : store::in_short(version.digest);
}

Axis version_axis(const History& history) {
  const std::vector<store::Version>& versions = history.versions;
  Axis axis;
  axis.label = history.code.empty() ? "commit" : "version of " + history.code;
  axis.names = true;
  axis.from = 0.5;
  axis.to = static_cast<double>(versions.size()) + 0.5;
  const std::size_t last = versions.size() - 1, step = 1 + last / most_commits;
  for (std::size_t v = last % step; v <= last; v += step)
    axis.tics.push_back({static_cast<double>(v + 1), name_of(versions[v], history)});
  return axis;
}

bool is_unstable(const std::string& remark) {
  return remark == to_string(records::Status::unstable);
}

Curve trend_curve(const Trend& trend, int style) {
  Curve curve{label(trend), label(trend), style, true, true, true, {}};
  for (std::size_t v = 0; v < trend.numbers.size(); ++v) {
    const double number = trend.numbers[v];
    const bool drawable = std::isfinite(number);
    const std::string remark = v < trend.remarks.size() ? trend.remarks[v] : "";
    const Mark mark = drawable ? (remark.empty() ? Mark::inside : Mark::outside)
                               : (is_unstable(remark) ? Mark::unstable : Mark::absent);
    curve.dots.push_back({static_cast<double>(v + 1), number, number, mark});
  }
  return curve;
}

bool marks(const Chart& chart, Mark mark) {
  return std::ranges::any_of(
      chart.curves, [mark](const Curve& curve) { return std::ranges::count(curve.dots, mark, &Dot::mark) > 0; });
}

/// Marks as many versions as a curve has room for, the newest among them. Only for a chart on which all dots are alike:
/// one that stands out must not be lost.
void thin_marks(Chart& chart) {
  const std::size_t every = 1 + (chart.curves.front().dots.size() - 1) / most_markers_drawn;
  if (every == 1) return;
  for (Curve& curve : chart.curves) curve.every = every;
  chart.caption += fmt::format(" One version in {} has a mark.", every);
}

/// Places the crosses, and says in the caption what the marks mean that not every chart
/// has.
void place_marks(Chart& chart) {
  constexpr double row_of_crosses = 0.07;  // of an axis that is low
  add_unstable_band(chart, row_of_crosses);
  if (marks(chart, Mark::outside)) chart.caption += " Hollow: a run of the window is unstable or failed.";
  if (marks(chart, Mark::unstable)) chart.caption += " Crosses in the band at the upper edge: unstable.";
  if (marks(chart, Mark::absent)) chart.caption += " Without a mark: not run, or failed.";
  const auto occurs = [&](Mark mark) { return marks(chart, mark); };
  if (std::ranges::none_of(std::array{Mark::outside, Mark::unstable, Mark::absent}, occurs)) thin_marks(chart);
}

/// Whether the trend has two numbers or more, or one and a version whose run is unstable: one number alone has no
/// course, also where a run of it is unstable.
bool has_course(const Trend& trend) {
  const Curve curve = trend_curve(trend, 0);
  const auto count = [&](Mark mark) { return std::ranges::count(curve.dots, mark, &Dot::mark); };
  const auto numbers = count(Mark::inside) + count(Mark::outside);
  return numbers >= 2 || (numbers == 1 && count(Mark::unstable) > 0);
}

/// What a name says around the series between their first and last quote: "error of '" and "' in l2".
struct Around {
  std::string before, after;
  bool operator==(const Around&) const = default;
};

std::optional<Around> around_series(const std::string& name) {
  const auto first = name.find('\''), last = name.rfind('\'');
  if (first == last) return std::nullopt;
  return Around{name.substr(0, first), name.substr(last + 1)};
}

/// Where all curves say the same of different series, their keys become the series, and the caption says the rest.
void shorten_keys(Chart& chart, const std::string& study, const std::string& where) {
  const auto around = around_series(chart.curves.front().name);
  const auto says_the_same = [&](const Curve& curve) { return around_series(curve.name) == around; };
  if (!around || !std::ranges::all_of(chart.curves, says_the_same)) return;
  for (Curve& curve : chart.curves)
    curve.key = curve.name.substr(around->before.size() + 1,
                                  curve.name.size() - around->before.size() - around->after.size() - 2);
  chart.caption = fmt::format("Study {}: {}each series{} in {}.", study, around->before, around->after, where);
}

/// Whether a logarithmic axis has a place for each number that was measured: an `energy_loss` may be negative.
bool are_positive(const std::vector<double>& numbers) {
  return std::ranges::none_of(numbers, [](double number) { return number <= 0; });
}

std::vector<const Trend*> drawn_trends(const std::string& study, const History& history) {
  std::vector<const Trend*> drawn;
  for (const Trend& trend : history.trends)
    if (trend.study == study && trend.kind != Finding::Kind::value && has_course(trend)) drawn.push_back(&trend);
  return drawn;
}

Chart trend_chart(const std::string& study, const Shown& shown, const History& history) {
  const std::string& code = history.code;
  const std::string where = code.empty() ? "each version" : "each version of " + code;
  const std::string label = axis_label_of(shown);
  Chart chart;
  chart.name = fmt::format("{}{}-{}", code.empty() ? "" : code + "~", study, file_part(shown));
  chart.caption = fmt::format("Study {}: {} in {}.", study, label.substr(0, label.find(" (")), where);
  chart.height = 240;
  chart.right_margin = name_of(history.versions.back(), history).size() / 2;  // below the frame's right corner
  std::vector<const Trend*> trends = drawn_trends(study, history);
  std::erase_if(trends, [&](const Trend* trend) { return shown_in(*trend) != shown; });
  std::vector<double> numbers;
  for (const Trend* trend : trends) numbers.insert(numbers.end(), trend->numbers.begin(), trend->numbers.end());
  const bool log = shown.kind == Finding::Kind::error && are_positive(numbers);
  for (const Trend* trend : trends) chart.curves.push_back(trend_curve(*trend, static_cast<int>(chart.curves.size())));
  shorten_keys(chart, study, where);
  chart.x = version_axis(history);
  chart.y = make_axis({label, log, {}, {}, 0.1, 0.1}, numbers);
  place_marks(chart);
  return chart;
}

}  // namespace

std::vector<Chart> trend_charts(const std::string& study, const History& history) {
  std::vector<Shown> all;
  for (const Trend* trend : drawn_trends(study, history))
    if (std::ranges::find(all, shown_in(*trend)) == all.end()) all.push_back(shown_in(*trend));
  std::ranges::stable_sort(all, {}, &Shown::kind);
  std::vector<Chart> charts;
  for (const Shown& shown : all) charts.push_back(trend_chart(study, shown, history));
  return charts;
}

}  // namespace mpmvv::reports
