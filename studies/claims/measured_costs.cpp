#include "studies/claims/measured_costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "studies/claims/found_text.hpp"
#include "studies/claims/samples.hpp"
#include "studies/claims/window_points.hpp"
#include "studies/fits/replicates.hpp"
#include "studies/fits/work_precision.hpp"

namespace mpmvv::claims {

using records::Point;
using records::Series;
using records::StudyResult;

namespace {

bool is_time(const std::string& norm) {
  return norm == "ns_per_particle_step";
}

/// Half the width of the interval of the mean of replicates; 0 without any.
double half_width_of_replicates(const Point& point, const std::string& norm) {
  const auto all = point.replicates.find(norm);
  if (all == point.replicates.end() || all->second.size() < 2) return 0;
  const fits::ReplicateMean mean = fits::mean_of_replicates(all->second);
  return (mean.upper - mean.lower) / 2;
}

/// A weighted sum of what was measured at points of a series.
struct Sum {
  std::vector<double> weights = {}, values = {}, half_ranges = {};
  std::vector<fits::Rounds> rounds = {};

  void add(const Point& point, const std::string& norm) {
    values.push_back(error_at(point, norm));
    half_ranges.push_back(is_time(norm) ? values.back() * half_spread(point) : half_width_of_replicates(point, norm));
    rounds.push_back(is_time(norm) ? point.rounds : fits::Rounds{});
  }
  double of(std::span<const double> numbers) const {
    if (numbers.empty()) return support::not_measured;
    return std::inner_product(weights.begin(), weights.end(), numbers.begin(), 0.0);
  }
  fits::Ranged ranged() const {
    double squares = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) squares += std::pow(weights[k] * half_ranges[k], 2);
    return {of(values), std::sqrt(squares)};
  }
};

/// Slope of the least-squares line through the points in the window; NaN when there are no two, or when one is unstable
/// or not measured.
Sum slope_of(const Criterion& c, const Series& series) {
  Sum sum;
  std::vector<double> x;
  for (const Point& point : series.points)
    if (c.window.holds(point.x)) x.push_back(point.x), sum.add(point, c.norm);
  const double mean = x.empty() ? 0 : boost::math::statistics::mean(x);
  double width = 0;
  for (const double one : x) width += std::pow(one - mean, 2);
  const bool is_known = std::ranges::all_of(sum.values, [](double value) { return std::isfinite(value); });
  for (const double one : x) sum.weights.push_back(is_known ? (one - mean) / width : support::not_measured);
  return sum;
}

/// The value of the first point in the window; NaN when there is none, or when it is unstable or not measured.
Sum first_value(const Criterion& c, const Series& series) {
  Sum sum;
  for (const Point& point : series.points)
    if (sum.values.empty() && c.window.holds(point.x)) sum.add(point, c.norm);
  for (const double value : sum.values) sum.weights.push_back(std::isfinite(value) ? 1 : support::not_measured);
  return sum;
}

/// The rounds of both; empty unless they are paired.
std::vector<fits::Rounds> paired(const Sum& a, const Sum& b) {
  std::vector<fits::Rounds> all = a.rounds;
  all.insert(all.end(), b.rounds.begin(), b.rounds.end());
  return fits::are_paired(all) ? all : std::vector<fits::Rounds>{};
}

/// Anywhere where the divisor's sign depends on a round.
fits::Estimate quotient(const Sum& a, const Sum& b) {
  const double divisor = b.ranged().value;
  const auto rounds = paired(a, b);
  if (rounds.empty() || !std::isfinite(a.ranged().value / divisor)) return fits::quotient(a.ranged(), b.ranged());
  return fits::over_rounds(rounds, [&](std::span<const double> costs) {
    const double now = b.of(costs.subspan(a.values.size()));
    return now * divisor > 0 ? a.of(costs.first(a.values.size())) / now : std::numeric_limits<double>::infinity();
  });
}

/// Adds a quotient with its interval. One of ranges of times is wider than one of rounds, so the evidence says which it
/// is.
void add(const std::string& label, const fits::Estimate& quotient, bool is_of_ranges, Measured& out) {
  out.add(label, quotient.value, Interval{quotient.lower, quotient.upper});
  records::Found& found = out.numbers.back().found;
  if (is_of_ranges && has_interval(found)) found.remark = "not timed in the same rounds";
}

/// Says which of two series another code ran, whose time is not that of the steps alone.
void remark_on_processes(const Series& series, const Series& over, records::Found& found) {
  for (const Series* one : {&series, &over})
    if (records::is_of_another_code(*one))
      found.remark += fmt::format("{}'{}': time of the whole process", found.remark.empty() ? "" : ", ", one->name);
}

/// What a series has to pay for which error.
struct CostCurve {
  std::vector<fits::WorkPoint> front;  ///< empty also where all runs are unstable: nothing buys any error
  std::string missing;                 ///< says what of it is not known; else empty

  /// An error that is not reached costs infinitely much, unless a run that is missing might reach it.
  fits::WorkPoint work_to_reach(double error) const {
    fits::WorkPoint work = fits::work_to_reach(error, front);
    if (std::isinf(work.cost) && !missing.empty()) work.cost = support::not_measured;
    return work;
  }
};

CostCurve cost_curve_of(const Series& series, const std::string& norm, const StudyResult& result) {
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  CostCurve curve{fits::pareto_front(work_points(series, norm)), failures_of(series, {-anywhere, anywhere}, result)};
  const auto is_unstable = [](const Point& point) { return point.status == records::Status::unstable; };
  const bool never_stable = !series.points.empty() && std::ranges::all_of(series.points, is_unstable);
  if (curve.missing.empty() && curve.front.empty() && !never_stable)
    curve.missing = fmt::format("no cost of '{}'", series.name);
  return curve;
}

}  // namespace

void measure_slope(const Criterion& c, const StudyResult& result, const Series& series, const Series& over,
                   Measured& out) {
  const bool share = c.kind == Criterion::Kind::slope_share;
  const std::string label = fmt::format("slope of '{}' in {} over {} of '{}', {}", series.name, c.norm,
                                        share ? "the value" : "that", over.name, over_window(c, result));
  const Sum slope = slope_of(c, series), divisor = share ? first_value(c, over) : slope_of(c, over);
  add(label, quotient(slope, divisor), is_time(c.norm) && paired(slope, divisor).empty(), out);
}

void measure_cost_ratios(const Criterion& c, const StudyResult& result, const Series& series, const Series& over,
                         Measured& out) {
  const CostCurve own = cost_curve_of(series, c.norm, result), other = cost_curve_of(over, c.norm, result);
  for (const CostCurve* curve : {&own, &other}) out.add_missing(curve->missing);
  for (const double error : fits::decades(c.window.from, c.window.to)) {
    const std::string label = fmt::format("cost of '{}' over '{}' at {} {:.0e}", series.name, over.name, c.norm, error);
    const fits::WorkPoint work = own.work_to_reach(error), other_work = other.work_to_reach(error);
    if (std::isinf(work.cost) && std::isinf(other_work.cost))
      out.add(label, support::not_measured, "neither ever reaches it");
    else if (std::isinf(work.cost))
      out.add(label, work.cost, fmt::format("'{}' never reaches it", series.name));
    else if (std::isinf(other_work.cost))
      out.add(label, work.cost / other_work.cost, fmt::format("'{}' never reaches it", over.name));
    else
      add(label, fits::quotient(work, other_work), !fits::are_paired(std::array{work.rounds, other_work.rounds}), out);
    if (!std::isinf(work.cost) && !std::isinf(other_work.cost))
      remark_on_processes(series, over, out.numbers.back().found);
  }
}

}  // namespace mpmvv::claims
