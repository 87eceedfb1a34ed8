#include "studies/claims/measured_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "studies/claims/window_points.hpp"
#include "studies/fits/replicates.hpp"

namespace mpmvv::claims {

using records::Point;
using records::Series;
using records::StudyResult;

namespace {

/// The replicates' values of a norm at a swept value; empty without replicates.
std::vector<double> replicates_at(const Series& series, double x, const std::string& norm) {
  for (const Point& point : series.points)
    if (const auto all = point.replicates.find(norm); all != point.replicates.end() && fits::same_level(point.x, x))
      return all->second;
  return {};
}

/// The interval of the mean of replicates, or the number alone where there are none.
Interval interval_of(double value, const std::vector<double>& replicates) {
  if (replicates.size() < 2) return {value, value};
  const fits::ReplicateMean mean = fits::mean_of_replicates(replicates);
  return {mean.lower, mean.upper};
}

void add_mean(const std::string& label, double value, const std::vector<double>& replicates, Measured& out) {
  out.add(label, value, interval_of(value, replicates));
}

/// Adds a ratio with the interval of its replicates: runs with the same offset or order, one divided by the other.
/// Where one is not above 0, their geometric mean is not the ratio of the means, and nothing is known of it.
void add_mean_ratio(const std::string& label, double value, const std::vector<double>& own,
                    const std::vector<double>& other, Measured& out) {
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  const auto above_0 = [](double v) { return v > 0; };
  std::vector<double> ratios;
  if (own.size() == other.size()) std::ranges::transform(own, other, std::back_inserter(ratios), std::divides{});
  if (ratios.empty() || (std::ranges::all_of(own, above_0) && std::ranges::all_of(other, above_0)))
    return add_mean(label, value, ratios, out);
  out.add(label, value, Interval{-anywhere, anywhere});
}

/// Says which number of a series makes no ratio: of one below 0 the sign would decide, and nothing is divided by 0.
std::string no_ratio(const Criterion& c, const StudyResult& result, const Series& series, double x) {
  return fmt::format("'{}' has {} = {:.4g} {}, and a ratio needs numbers above 0", series.name, c.norm,
                     error_at(series, x, c.norm), at_point(result, x));
}

}  // namespace

void measure_errors(const Criterion& c, const StudyResult& result, const Series& series, Measured& out) {
  for (const Point& point : series.points)
    if (c.window.holds(point.x))
      add_mean(fmt::format("{} of '{}' {}", c.norm, series.name, at_point(result, point.x)), error_at(point, c.norm),
               replicates_at(series, point.x, c.norm), out);
}

void measure_ratios(const Criterion& c, const StudyResult& result, const Series& series, const Series& over,
                    Measured& out) {
  for (const Point& point : series.points) {
    if (!c.window.holds(point.x)) continue;
    const double own = error_at(point, c.norm), other = error_at(over, point.x, c.norm);
    if (own < 0 || other <= 0)
      out.missing = no_ratio(c, result, own < 0 ? series : over, point.x);
    else {
      const bool both_unstable = std::isinf(own) && std::isinf(other);
      const std::string label =
          fmt::format("{} of '{}' over '{}' {}", c.norm, series.name, over.name, at_point(result, point.x));
      if (both_unstable)
        out.add(label, 1, "both unstable");
      else
        add_mean_ratio(label, own / other, replicates_at(series, point.x, c.norm), replicates_at(over, point.x, c.norm),
                       out);
    }
  }
}

void measure_spread(const Criterion& c, const StudyResult& result, const Series& series, Measured& out) {
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  double least = anywhere, largest = 0;
  Interval of_least{anywhere, anywhere}, of_largest{0, 0};
  for (const Point& point : series.points) {
    if (!c.window.holds(point.x)) continue;
    const double error = error_at(point, c.norm);
    if (!(error > 0)) {
      out.missing = failures_of(series, c.window, result);
      if (out.missing.empty())
        out.missing = std::isnan(error)
                          ? fmt::format("'{}' has no {} {}", series.name, c.norm, at_point(result, point.x))
                          : no_ratio(c, result, series, point.x);
      return;
    }
    const Interval interval = interval_of(error, replicates_at(series, point.x, c.norm));
    least = std::min(least, error), largest = std::max(largest, error);
    of_least = {std::min(of_least.lower, interval.lower), std::min(of_least.upper, interval.upper)};
    of_largest = {std::max(of_largest.lower, interval.lower), std::max(of_largest.upper, interval.upper)};
  }
  if (std::isinf(least) && !c.at_most)
    out.missing = fmt::format("no run of '{}' is stable {}", series.name, over_window(c, result));
  const std::string label =
      fmt::format("largest over smallest {} of '{}' {}", c.norm, series.name, over_window(c, result));
  if (std::isinf(largest)) return out.add(label, largest);
  const double most = of_least.lower > 0 ? of_largest.upper / of_least.lower : anywhere;
  out.add(label, largest / least, Interval{std::max(1.0, of_largest.lower / of_least.upper), most});
}

}  // namespace mpmvv::claims
