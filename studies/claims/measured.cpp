#include "studies/claims/measured.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "studies/claims/measured_costs.hpp"
#include "studies/claims/measured_errors.hpp"
#include "studies/claims/measured_limits.hpp"
#include "studies/claims/measured_orders.hpp"
#include "studies/claims/window_points.hpp"
#include "studies/fits/window.hpp"

namespace mpmvv::claims {

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
  if (const auto failed = values_with(Status::failed, c.window, series); !failed.empty())
    out.missing = fmt::format("'{}' could not be run at {}", series.name, fmt::join(failed, ", "));
  out.add(fmt::format("stable share of '{}' {}", series.name, over_window(c, result)), ok / all);
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

/// Whether the measure leaves it to its caller to say that a run failed: its number at that point alone is not known.
bool reads_single_points(Criterion::Kind kind) {
  using enum Criterion::Kind;
  return kind == error || kind == error_ratio || kind == spread || kind == slope_ratio || kind == slope_share;
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
      return measure_cost_ratios(c, result, series, *over, out);
    case Criterion::Kind::value:
    case Criterion::Kind::awaited:
    case Criterion::Kind::shown:
      break;
  }
}

}  // namespace

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
    if (series && own.missing.empty() && reads_single_points(c.kind))
      out.add_missing(failures_of(*series, c.window, result));
  }
  // Of the divisor of `slope-share` one value alone is read.
  if (over && reads_single_points(c.kind) && c.kind != Criterion::Kind::slope_share)
    out.add_missing(failures_of(*over, c.window, result));
  return out;
}

}  // namespace mpmvv::claims
