#include "studies/claims/measured.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/statistics/linear_regression.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "studies/claims/measured_orders.hpp"
#include "studies/claims/samples.hpp"
#include "studies/claims/window_points.hpp"
#include "studies/fits/window.hpp"
#include "studies/fits/work_precision.hpp"

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

void measure_errors(const Criterion& c, const StudyResult& result, const Series& series, Measured& out) {
  for (const Point& point : series.points)
    if (c.window.holds(point.x))
      out.add(fmt::format("{} of '{}' {}", c.norm, series.name, at_point(result, point.x)), error_at(point, c.norm));
}

/// Says which number of a series makes no ratio: of one below 0 the sign would decide, and nothing is divided by 0.
std::string no_ratio(const Criterion& c, const StudyResult& result, const Series& series, double x) {
  return fmt::format("'{}' has {} = {:.4g} {}, and a ratio needs numbers above 0", series.name, c.norm,
                     error_at(series, x, c.norm), at_point(result, x));
}

/// The ratio of two unstable runs is 1: W gives each of them the same error, one.
void measure_ratios(const Criterion& c, const StudyResult& result, const Series& series, const Series& over,
                    Measured& out) {
  for (const Point& point : series.points) {
    if (!c.window.holds(point.x)) continue;
    const double own = error_at(point, c.norm), other = error_at(over, point.x, c.norm);
    if (own < 0 || other <= 0)
      out.missing = no_ratio(c, result, own < 0 ? series : over, point.x);
    else
      out.add(fmt::format("{} of '{}' over '{}' {}", c.norm, series.name, over.name, at_point(result, point.x)),
              std::isinf(own) && std::isinf(other) ? 1 : own / other);
  }
}

/// An unstable run makes the spread infinite. Where all are unstable, this does not show how far apart they lie, so a
/// lower bound alone cannot be judged.
void measure_spread(const Criterion& c, const StudyResult& result, const Series& series, Measured& out) {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (const Point& point : series.points) {
    if (!c.window.holds(point.x)) continue;
    const double error = error_at(point, c.norm);
    if (!(error > 0)) {
      out.missing = std::isnan(error) ? fmt::format("'{}' has no {} at {}", series.name, c.norm, point.x)
                                      : no_ratio(c, result, series, point.x);
      return;
    }
    least = std::min(least, error), largest = std::max(largest, error);
  }
  if (std::isinf(least) && !c.at_most)
    out.missing = fmt::format("no run of '{}' is stable {}", series.name, over_window(c, result));
  out.add(fmt::format("largest over smallest {} of '{}' {}", c.norm, series.name, over_window(c, result)),
          std::isinf(largest) ? largest : largest / least);
}

/// Slope of the least-squares line through the points in the window; NaN when there are no two, or when one is unstable
/// or not measured.
double slope_of(const Criterion& c, const Series& series) {
  std::vector<double> x, y;
  for (const Point& point : series.points)
    if (c.window.holds(point.x)) x.push_back(point.x), y.push_back(error_at(point, c.norm));
  if (x.size() < 2) return support::not_measured;
  return boost::math::statistics::simple_ordinary_least_squares(x, y).second;
}

double first_value(const Criterion& c, const Series& series) {
  for (const Point& point : series.points)
    if (c.window.holds(point.x)) return error_at(point, c.norm);
  return support::not_measured;
}

void measure_slope(const Criterion& c, const StudyResult& result, const Series& series, const Series& over,
                   Measured& out) {
  const bool share = c.kind == Criterion::Kind::slope_share;
  out.add(fmt::format("slope of '{}' in {} over {} of '{}', {}", series.name, c.norm, share ? "the value" : "that",
                      over.name, over_window(c, result)),
          slope_of(c, series) / (share ? first_value(c, over) : slope_of(c, over)));
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

/// Says which of two series never gets down to the error, or that neither does; empty when both do.
std::string never_there(const Series& series, double cost, const Series& over, double other_cost) {
  if (std::isinf(cost) && std::isinf(other_cost)) return "neither ever reaches it";
  if (std::isinf(cost)) return fmt::format("'{}' never reaches it", series.name);
  return std::isinf(other_cost) ? fmt::format("'{}' never reaches it", over.name) : "";
}

/// What a series has to pay for which error: nothing buys any where all its runs are unstable. `out.missing` says where
/// it is not known.
std::vector<fits::WorkPoint> front_of(const Series& series, const std::string& norm, Measured& out) {
  auto front = fits::pareto_front(work_points(series, norm));
  const auto is_unstable = [](const Point& point) { return point.status == Status::unstable; };
  const bool never_stable = !series.points.empty() && std::ranges::all_of(series.points, is_unstable);
  if (front.empty() && !never_stable) out.missing = fmt::format("no cost of '{}'", series.name);
  return front;
}

/// A series that never gets down to an error costs infinitely much there, whatever the other one does. Where neither
/// gets there, this does not show how much more it costs, so a lower bound alone cannot be judged.
void measure_cost_ratios(const Criterion& c, const Series& series, const Series& over, Measured& out) {
  const auto own = front_of(series, c.norm, out), other = front_of(over, c.norm, out);
  for (const double error : fits::decades(c.window.from, c.window.to)) {
    const double cost = fits::cost_to_reach(error, own), other_cost = fits::cost_to_reach(error, other);
    out.add(fmt::format("cost of '{}' over '{}' at {} {:.0e}", series.name, over.name, c.norm, error),
            std::isinf(cost) ? cost : cost / other_cost, never_there(series, cost, over, other_cost));
    if (std::isinf(cost) && std::isinf(other_cost) && !c.at_most)
      out.missing = fmt::format("neither '{}' nor '{}' reaches {} {:.0e}", series.name, over.name, c.norm, error);
  }
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

Measured measure(const Criterion& c, const StudyResult& result) {
  Measured out;
  if (c.kind == Criterion::Kind::value) {
    measure_value(c, result, out);
    return out;
  }
  const Series* over = c.over.empty() ? nullptr : find_series(result, c.over);
  for (const std::string& name : c.series) {
    const Series* series = find_series(result, name);
    if (!series || (!c.over.empty() && !over)) {
      out.missing = fmt::format("there is no series '{}'", series ? c.over : name);
      return out;
    }
    if (reads_points(c.kind) &&
        std::ranges::none_of(series->points, [&](const Point& p) { return c.window.holds(p.x); }))
      out.missing = fmt::format("'{}' has no point {}", name, over_window(c, result));
    else
      measure_series(c, result, *series, over, out);
  }
  return out;
}

}  // namespace mpmvv::claims
