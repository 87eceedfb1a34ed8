#include "studies/claims/measured_costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/statistics/linear_regression.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <limits>

#include "studies/claims/samples.hpp"
#include "studies/claims/window_points.hpp"
#include "studies/fits/work_precision.hpp"

namespace mpmvv::claims {

using records::Point;
using records::Series;
using records::StudyResult;

namespace {

/// A number that times make, and how far it may lie from there.
struct Known {
  double value, half_range = 0;
};

/// The norm at a point; of a time also half the range of its repetitions.
Known known_at(const Point& point, const std::string& norm) {
  const double value = error_at(point, norm);
  return {value, norm == "ns_per_particle_step" ? value * half_spread(point) : 0};
}

/// Slope of the least-squares line through the points in the window; NaN when there are no two, or when one is unstable
/// or not measured.
Known slope_of(const Criterion& c, const Series& series) {
  std::vector<double> x, y, half_ranges;
  for (const Point& point : series.points) {
    if (!c.window.holds(point.x)) continue;
    const auto [value, half_range] = known_at(point, c.norm);
    x.push_back(point.x), y.push_back(value), half_ranges.push_back(half_range);
  }
  if (x.size() < 2) return {support::not_measured};
  const double mean = boost::math::statistics::mean(x);
  double width = 0, squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    width += std::pow(x[k] - mean, 2);
    squares += std::pow((x[k] - mean) * half_ranges[k], 2);
  }
  return {boost::math::statistics::simple_ordinary_least_squares(x, y).second, std::sqrt(squares) / width};
}

Known first_value(const Criterion& c, const Series& series) {
  for (const Point& point : series.points)
    if (c.window.holds(point.x)) return known_at(point, c.norm);
  return {support::not_measured};
}

/// Where the quotient may lie: anywhere where the divisor may be 0.
Interval quotient(const Known& a, const Known& b) {
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  if (b.half_range == 0 && a.half_range == 0) return {a.value / b.value, a.value / b.value};
  if (!(std::abs(b.value) > b.half_range)) return {-anywhere, anywhere};
  const double low = a.value - a.half_range, high = a.value + a.half_range;
  const double least = b.value - b.half_range, most = b.value + b.half_range;
  const auto [lower, upper] = std::minmax({low / least, low / most, high / least, high / most});
  return {lower, upper};
}

void add_quotient(const std::string& label, const Known& a, const Known& b, Measured& out) {
  const Interval interval = quotient(a, b);
  out.add(label, a.value / b.value, interval, range_text(interval));
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
  const auto is_unstable = [](const Point& point) { return point.status == records::Status::unstable; };
  const bool never_stable = !series.points.empty() && std::ranges::all_of(series.points, is_unstable);
  if (front.empty() && !never_stable) out.missing = fmt::format("no cost of '{}'", series.name);
  return front;
}

}  // namespace

void measure_slope(const Criterion& c, const StudyResult& result, const Series& series, const Series& over,
                   Measured& out) {
  const bool share = c.kind == Criterion::Kind::slope_share;
  const std::string label = fmt::format("slope of '{}' in {} over {} of '{}', {}", series.name, c.norm,
                                        share ? "the value" : "that", over.name, over_window(c, result));
  add_quotient(label, slope_of(c, series), share ? first_value(c, over) : slope_of(c, over), out);
}

void measure_cost_ratios(const Criterion& c, const Series& series, const Series& over, Measured& out) {
  const auto own = front_of(series, c.norm, out), other = front_of(over, c.norm, out);
  for (const double error : fits::decades(c.window.from, c.window.to)) {
    const std::string label = fmt::format("cost of '{}' over '{}' at {} {:.0e}", series.name, over.name, c.norm, error);
    const auto [cost, own_error, half_range] = fits::work_to_reach(error, own);
    const auto [other_cost, other_error, other_half_range] = fits::work_to_reach(error, other);
    if (const std::string never = never_there(series, cost, over, other_cost); !never.empty())
      out.add(label, std::isinf(cost) ? cost : 0, never);
    else
      add_quotient(label, {cost, half_range}, {other_cost, other_half_range}, out);
    if (std::isinf(cost) && std::isinf(other_cost) && !c.at_most)
      out.missing = fmt::format("neither '{}' nor '{}' reaches {} {:.0e}", series.name, over.name, c.norm, error);
  }
}

}  // namespace mpmvv::claims
