#include "studies/claims/measured_orders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>

#include "studies/claims/samples.hpp"
#include "studies/claims/window_points.hpp"
#include "studies/fits/replicates.hpp"

namespace mpmvv::claims {

using fits::ObservedOrder;
using records::Point;
using records::Series;
using records::Status;
using records::StudyResult;

namespace {

/// Why the fit does without `missing` of the `all` points that are not unstable.
std::string why_missing(const Criterion& c, const StudyResult& result, const Series& series, const std::string& norm,
                        std::ptrdiff_t missing, std::ptrdiff_t all) {
  if (std::string failures = failures_of(series, c.window, result); !failures.empty()) return failures;
  const std::string near_floor = left_out(series, norm, c.window);
  return fmt::format("'{}': {} of {} stable points are no use{}", series.name, missing, all,
                     near_floor.empty() ? "" : ", left out: " + near_floor);
}

/// Says at which swept value in the window a replicate is not above 0, so that it has no logarithm and the scatter of
/// the others says too little; empty where all are.
std::string no_logarithm(const Criterion& c, const StudyResult& result, const Series& series, const std::string& norm) {
  for (const Point& point : series.points) {
    const auto all = point.replicates.find(norm);
    if (!c.window.holds(point.x) || all == point.replicates.end()) continue;
    if (std::ranges::any_of(all->second, [](double e) { return !(e > 0); }))
      return fmt::format("'{}' has a replicate with {} not above 0 {}", series.name, norm, at_point(result, point.x));
  }
  return "";
}

/// The order over the stable points in the window. Sets `out.missing` when one of them failed or has no usable error.
ObservedOrder stable_order(const Criterion& c, const StudyResult& result, const Series& series, const std::string& norm,
                           Measured& out) {
  ObservedOrder fit = fits::fit_order(samples_of(series, norm, result.sweep), c.window.from, c.window.to);
  if (const auto all = replicate_samples_of(series, norm, result.sweep); !all.empty())
    fit.replicates = fits::fit_replicates(all, c.window.from, c.window.to);
  const auto stable = std::count_if(series.points.begin(), series.points.end(), [&](const Point& point) {
    return c.window.holds(point.x) && point.status != Status::unstable;
  });
  if (out.missing.empty()) out.missing = no_logarithm(c, result, series, norm);
  if (fit.points < stable) out.missing = why_missing(c, result, series, norm, stable - fit.points, stable);
  return fit;
}

/// The order with its interval. Where the finest segment lies outside of it, that is said, too: the order is that over
/// the window and not beyond.
void add_order(const std::string& label, const ObservedOrder& fit, const StudyResult& result, const std::string& remark,
               Measured& out) {
  constexpr double least_seen = 0.005;
  const double width = fits::half_width(fit), finest = finest_segment(fit, is_finer(fit.to, fit.from, result.sweep));
  std::vector<std::string> remarks;
  if (width > 0 && std::abs(finest - fit.order) > std::max(1.001 * width, least_seen))
    remarks.push_back(fmt::format("finest segment {:.2f}", finest));
  if (!remark.empty()) remarks.push_back(remark);
  out.add(label, fit.order, Interval{fit.order - width, fit.order + width},
          fmt::format("{}", fmt::join(remarks, ", ")));
}

/// A series with one quantity: `norm` divided by `over_norm`, under the name `norm`.
Series quotient(const Series& series, const std::string& norm, const std::string& over_norm) {
  Series quotient{series.name, {}, {}, {}};
  for (const Point& point : series.points) {
    Point ratio{point.x, point.status, point.reason, {{norm, error_at(point, norm) / error_at(point, over_norm)}}};
    if (const auto cfl = point.y.find("cfl"); cfl != point.y.end()) ratio.y.insert(*cfl);
    const auto own = point.replicates.find(norm), other = point.replicates.find(over_norm);
    if (own != point.replicates.end() && other != point.replicates.end() && own->second.size() == other->second.size())
      std::ranges::transform(own->second, other->second, std::back_inserter(ratio.replicates[norm]), std::divides{});
    quotient.points.push_back(ratio);
  }
  return quotient;
}

}  // namespace

void measure_order(const Criterion& c, const StudyResult& result, const Series& series, Measured& out) {
  const ObservedOrder fit = stable_order(c, result, series, c.norm, out);
  const std::vector<double> unstable = values_with(Status::unstable, c.window, series);
  const bool is_decided = !unstable.empty() && c.at_least;  // a lower bound fails, whatever the order of the others
  if (!unstable.empty() && !is_decided && fit.points < 3 && !fit.replicates && out.missing.empty())
    out.missing = fmt::format("too few points of '{}' are stable: {} of at least 3", series.name, fit.points);
  const std::string without = unstable.empty() ? "" : fmt::format("unstable at {}", fmt::join(unstable, ", "));
  if (!is_decided || !std::isnan(fit.order))
    add_order(fmt::format("order of '{}' in {} {}", series.name, c.norm, over_window(c, result)), fit, result, without,
              out);
  if (!is_decided) return;
  out.missing.clear();
  out.add(fmt::format("order of '{}' {}", series.name, at_point(result, unstable[0])),
          -std::numeric_limits<double>::infinity());
}

void measure_order_difference(const Criterion& c, const StudyResult& result, const Series& series, Measured& out) {
  const double own = stable_order(c, result, series, c.norm, out).order;
  const double other = stable_order(c, result, series, c.over_norm, out).order;
  const ObservedOrder fit = stable_order(c, result, quotient(series, c.norm, c.over_norm), c.norm, out);
  add_order(fmt::format("order of '{}' in {} ({:.2f}) less that in {} ({:.2f}) {}", series.name, c.norm, own,
                        c.over_norm, other, over_window(c, result)),
            fit, result, "", out);
  if (const auto unstable = values_with(Status::unstable, c.window, series); !unstable.empty())
    out.missing = fmt::format("'{}' is unstable at {}", series.name, fmt::join(unstable, ", "));
}

}  // namespace mpmvv::claims
