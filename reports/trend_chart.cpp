#include "reports/trend_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace mpmvv::reports {

using claims::Finding;
using claims::Trend;

namespace {

constexpr std::size_t commit_letters = 7, version_letters = 10;
constexpr std::size_t most_commits = 10;  ///< as texts below the axis

struct TrendKind {
  Finding::Kind kind;
  const char* name;  ///< of the file, behind the study's
  const char* label;
  bool log;
};

constexpr TrendKind trend_kinds[] = {{Finding::Kind::order, "orders", "observed order", false},
                                     {Finding::Kind::error, "errors", "error", true},
                                     {Finding::Kind::limit, "limits", "stability limit", false}};

/// The first letters of a commit, and whether its tree was dirty.
std::string commit_text(const std::string& commit) {
  const auto dash = std::min(commit.find('-'), commit.size());
  return commit.substr(0, std::min(dash, commit_letters)) + commit.substr(dash);
}

/// A commit, or what another code says of its version; its digest where that would read the same for several.
std::string name_of(const store::Version& version, const History& history) {
  const auto shown = [&](const store::Version& v) {
    const std::string& first = v.commits.front();
    return history.code.empty() ? commit_text(first) : first.substr(0, version_letters);
  };
  const bool is_unique = std::ranges::count(history.versions, shown(version), shown) == 1;
  return is_unique ? shown(version) : version.digest.substr(0, commit_letters);
}

Axis version_axis(const History& history) {
  const std::vector<store::Version>& versions = history.versions;
  Axis axis;
  axis.label = history.code.empty() ? "commit" : "version of " + history.code;
  axis.names = true;
  axis.from = 0.5;
  axis.to = static_cast<double>(versions.size()) + 0.5;
  const std::size_t step = 1 + (versions.size() - 1) / most_commits;
  for (std::size_t v = 0; v < versions.size(); v += step)
    axis.tics.push_back({static_cast<double>(v + 1), name_of(versions[v], history)});
  return axis;
}

bool is_unstable(const std::string& remark) {
  return remark == to_string(records::Status::unstable);
}

Curve trend_curve(const Trend& trend, int style, bool log) {
  Curve curve{label(trend), label(trend), style, true, true, true, {}};
  for (std::size_t v = 0; v < trend.numbers.size(); ++v) {
    const double number = trend.numbers[v];
    const bool drawable = std::isfinite(number) && (!log || number > 0);
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

/// Places the crosses of one version below each other, and says in the caption what the marks mean that not every chart
/// has.
void place_marks(Chart& chart) {
  std::map<double, int> at_x;
  for (Curve& curve : chart.curves)
    for (Dot& dot : curve.dots)
      if (dot.mark == Mark::unstable) dot.drawn = chart.y.value(1 - 0.03 - 0.05 * at_x[dot.x]++);
  if (marks(chart, Mark::outside)) chart.caption += " Hollow: a run of the window is unstable or failed.";
  if (marks(chart, Mark::unstable)) chart.caption += " Crosses at the upper edge: unstable.";
  if (marks(chart, Mark::absent)) chart.caption += " Without a mark: not run, or failed.";
}

/// Whether the trend has two numbers or more, or one and an unstable run: one number alone has no course.
bool has_course(const Trend& trend) {
  const auto numbers = std::ranges::count_if(trend.numbers, [](double number) { return std::isfinite(number); });
  return numbers >= 2 || (numbers == 1 && std::ranges::any_of(trend.remarks, is_unstable));
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

std::optional<Chart> trend_chart(const std::string& study, const TrendKind& kind, const History& history) {
  const std::string& code = history.code;
  const std::string where = code.empty() ? "each version" : "each version of " + code;
  Chart chart;
  chart.name = fmt::format("{}{}-{}", code.empty() ? "" : code + "~", study, kind.name);
  chart.caption = fmt::format("Study {}: {} in {}.", study, kind.label, where);
  chart.height = 240;
  std::vector<double> numbers;
  for (const Trend& trend : history.trends) {
    if (trend.study != study || trend.kind != kind.kind || !has_course(trend)) continue;
    chart.curves.push_back(trend_curve(trend, static_cast<int>(chart.curves.size()), kind.log));
    numbers.insert(numbers.end(), trend.numbers.begin(), trend.numbers.end());
  }
  if (chart.curves.empty()) return std::nullopt;
  shorten_keys(chart, study, where);
  chart.x = version_axis(history);
  chart.y = make_axis({kind.label, kind.log, {}, {}, 0.1, 0.1}, numbers);
  place_marks(chart);
  return chart;
}

}  // namespace

std::vector<Chart> trend_charts(const std::string& study, const History& history) {
  std::vector<Chart> charts;
  for (const TrendKind& kind : trend_kinds)
    if (auto chart = trend_chart(study, kind, history)) charts.push_back(std::move(*chart));
  return charts;
}

}  // namespace mpmvv::reports
