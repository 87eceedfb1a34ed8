#include "studies/claims/measured.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "studies/claims/measured_costs.hpp"
#include "studies/claims/measured_errors.hpp"
#include "studies/claims/measured_orders.hpp"
#include "studies/claims/window_points.hpp"
#include "studies/fits/window.hpp"

namespace mpmvv::claims {

using fits::StabilityLimit;
using records::Point;
using records::Series;
using records::Status;
using records::StudyResult;

namespace {

const Series* find_series(const StudyResult& result, const std::string& name) {
  for (const Series& series : result.series)
    if (series.name == name) return &series;
  return nullptr;
}

void measure_status(const Criterion& c, const StudyResult& result, const Series& series, Measured& out) {
  double ok = 0, all = 0;
  for (const Point& point : series.points)
    if (c.window.holds(point.x)) ok += point.status == Status::ok ? 1 : 0, ++all;
  if (const auto failed = values_with(Status::failed, c, series); !failed.empty())
    out.missing = fmt::format("'{}' could not be run at {}", series.name, fmt::join(failed, ", "));
  out.add(fmt::format("stable share of '{}' {}", series.name, over_window(c, result)), ok / all);
}

/// The limit of a series; where none was found null, and `out.missing` says why.
const StabilityLimit* limit_of(const Series& series, Measured& out) {
  if (series.limit && series.limit->found) return &*series.limit;
  out.missing = fmt::format("'{}' has no limit{}", series.name,
                            series.limit ? ": " + text_without_limit(*series.limit) : " in the range searched");
  return nullptr;
}

Interval bracket_of(const StabilityLimit& limit) {
  return {std::min(limit.stable, limit.unstable), std::max(limit.stable, limit.unstable)};
}

/// Where all probes agree, the limit lies beyond one end of what was tried: beyond the far end when all are stable,
/// beyond the end where the search began when all are unstable. The interval beyond that end.
std::optional<Interval> beyond_all_tried(const StabilityLimit& limit) {
  if (limit.probes.size() < 2) return std::nullopt;
  const double lowest = limit.probes.front().value, highest = limit.probes.back().value;
  const bool is_stable = limit.probes.front().stable;
  if (!std::ranges::all_of(limit.probes, [&](const fits::Probe& p) { return p.stable == is_stable; }))
    return std::nullopt;
  const double end = is_stable ? limit.stable : limit.unstable;
  if (end == lowest) return Interval{0, lowest};
  if (end == highest) return Interval{highest, std::numeric_limits<double>::infinity()};
  return std::nullopt;
}

void measure_limit(const Series& series, Measured& out) {
  if (const auto beyond = series.limit && !series.limit->found ? beyond_all_tried(*series.limit) : std::nullopt) {
    const bool is_below = beyond->lower == 0;
    const double end = is_below ? beyond->upper : beyond->lower;
    out.add(fmt::format("{} limit of '{}', {}", series.limit->key, series.name, text_without_limit(*series.limit)), end,
            *beyond);
    out.numbers.back().words = fmt::format("{} {:.4g}", is_below ? "below" : "above", end);
    return;
  }
  const StabilityLimit* limit = limit_of(series, out);
  if (!limit) return;
  out.add(fmt::format("{} limit of '{}' between {:.4g} and {:.4g}{}", limit->key, series.name, limit->stable,
                      limit->unstable, limit->monotone ? "" : ", not monotone"),
          limit->value(), bracket_of(*limit));
}

void measure_limit_ratio(const Series& series, const Series& over, Measured& out) {
  const StabilityLimit *own = limit_of(series, out), *other = limit_of(over, out);
  if (!own || !other) return;
  const Interval a = bracket_of(*own), b = bracket_of(*other), ratio{a.lower / b.upper, a.upper / b.lower};
  out.add(fmt::format("limit of '{}' over '{}' between {:.4g} and {:.4g}", series.name, over.name, ratio.lower,
                      ratio.upper),
          own->value() / other->value(), ratio);
}

void measure_value(const Criterion& c, const StudyResult& result, Measured& out) {
  for (const records::Value& value : result.values)
    if (value.name == c.name) return out.add(value.meaning, value.value);
  out.missing = fmt::format("the check has no value '{}'", c.name);
}

/// Whether the criterion reads the points inside its window.
bool reads_points(Criterion::Kind kind) {
  switch (kind) {
    case Criterion::Kind::order:
    case Criterion::Kind::order_difference:
    case Criterion::Kind::error:
    case Criterion::Kind::error_ratio:
    case Criterion::Kind::spread:
    case Criterion::Kind::slope_ratio:
    case Criterion::Kind::slope_share:
    case Criterion::Kind::status:
      return true;
    default:
      return false;
  }
}

/// `over` is not null where the measure divides by it.
void measure_series(const Criterion& c, const StudyResult& result, const Series& series, const Series* over,
                    Measured& out) {
  switch (c.kind) {
    case Criterion::Kind::order:
      return measure_order(c, result, series, out);
    case Criterion::Kind::order_difference:
      return measure_order_difference(c, result, series, out);
    case Criterion::Kind::error:
      return measure_errors(c, result, series, out);
    case Criterion::Kind::error_ratio:
      return measure_ratios(c, result, series, *over, out);
    case Criterion::Kind::spread:
      return measure_spread(c, result, series, out);
    case Criterion::Kind::slope_ratio:
    case Criterion::Kind::slope_share:
      return measure_slope(c, result, series, *over, out);
    case Criterion::Kind::status:
      return measure_status(c, result, series, out);
    case Criterion::Kind::limit:
      return measure_limit(series, out);
    case Criterion::Kind::limit_ratio:
      return measure_limit_ratio(series, *over, out);
    case Criterion::Kind::cost_ratio:
      return measure_cost_ratios(c, series, *over, out);
    case Criterion::Kind::value:
    case Criterion::Kind::awaited:
    case Criterion::Kind::shown:
      break;
  }
}

}  // namespace

std::string range_text(const Interval& interval) {
  const auto [lower, upper] = interval;
  if (std::isinf(upper)) return " (without bounds)";
  constexpr double round_off = 1e-12;
  if (!(upper - lower > round_off * std::max(std::abs(lower), std::abs(upper)))) return "";
  for (int digits = 3;; ++digits) {
    const std::string from = fmt::format("{:.{}g}", lower, digits), to = fmt::format("{:.{}g}", upper, digits);
    if (from != to) return " (" + from + " to " + to + ")";
  }
}

Measured measure(const Criterion& c, const StudyResult& result) {
  Measured out;
  if (c.kind == Criterion::Kind::value) {
    measure_value(c, result, out);
    return out;
  }
  const Series* over = c.over.empty() ? nullptr : find_series(result, c.over);
  for (const std::string& name : c.series) {
    const Series* series = find_series(result, name);
    Measured own;
    if (!series || (!c.over.empty() && !over))
      own.missing = fmt::format("there is no series '{}'", series ? c.over : name);
    else if (reads_points(c.kind) &&
             std::ranges::none_of(series->points, [&](const Point& p) { return c.window.holds(p.x); }))
      own.missing = fmt::format("'{}' has no point {}", name, over_window(c, result));
    else
      measure_series(c, result, *series, over, own);
    out.append(own);
  }
  return out;
}

}  // namespace mpmvv::claims
