#include "studies/fits/observed_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/fits/distributions.hpp"
#include "studies/fits/window.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::fits {

using support::not_measured;
namespace {

bool usable(const ErrorSample& s) {
  return std::isfinite(s.h) && s.h > 0 && std::isfinite(s.e);
}

bool has_error(const ErrorSample& s) {
  return usable(s) && s.e > 0;
}

struct Line {
  double slope = not_measured, intercept = not_measured, slope_error = not_measured, r_squared = not_measured;
};

/// Least squares of log e over log h; `slope_error` is the standard error of the slope.
Line fit_line(std::span<const ErrorSample> samples) {
  const auto n = static_cast<double>(samples.size());
  double mean_x = 0, mean_y = 0;
  for (const ErrorSample& s : samples) {
    mean_x += std::log(s.h) / n;
    mean_y += std::log(s.e) / n;
  }
  double xx = 0, xy = 0, yy = 0;
  for (const ErrorSample& s : samples) {
    const double x = std::log(s.h) - mean_x, y = std::log(s.e) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  Line line;
  line.slope = xy / xx;
  line.intercept = mean_y - line.slope * mean_x;
  double misfit = 0;
  for (const ErrorSample& s : samples) {
    const double r = std::log(s.e) - line.intercept - line.slope * std::log(s.h);
    misfit += r * r;
  }
  line.r_squared = 1 - misfit / yy;
  line.slope_error = std::sqrt(misfit / (n - 2) / xx);
  return line;
}

bool have_different_h(std::span<const ErrorSample> samples) {
  return std::any_of(samples.begin(), samples.end(), [&](const ErrorSample& s) { return s.h != samples.front().h; });
}

std::vector<SegmentOrder> segment_orders(std::span<const ErrorSample> samples) {
  std::vector<SegmentOrder> segments;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const ErrorSample &a = samples[k - 1], &b = samples[k];
    const double order = a.h == b.h ? not_measured : std::log(a.e / b.e) / std::log(a.h / b.h);
    segments.push_back({a.x, b.x, order});
  }
  return segments;
}

/// The segments that lie in the window.
std::span<const SegmentOrder> window_segments(const ObservedOrder& fit) {
  const Window window{fit.from, fit.to};
  const auto is_inside = [&](const SegmentOrder& s) { return window.holds(s.from) && window.holds(s.to); };
  const auto first = std::ranges::find_if(fit.segments, is_inside);
  return {first, std::find_if_not(first, fit.segments.end(), is_inside)};
}

/// Whether the segments are at least two whose orders agree, without a swept value between them that has no error.
bool agree(std::span<const SegmentOrder> segments, std::span<const ErrorSample> without_error) {
  if (segments.size() < 2) return false;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const SegmentOrder& s : segments) {
    if (std::isnan(s.order)) return false;
    lowest = std::min(lowest, s.order);
    highest = std::max(highest, s.order);
  }
  const auto lies_between = [&](const ErrorSample& s) {
    return s.x > segments.front().from && s.x < segments.back().to;
  };
  return highest - lowest <= asymptotic_spread && std::ranges::none_of(without_error, lies_between);
}

/// The longest run of agreeing segments, the last or the first of equally long ones; empty when there is none.
std::span<const SegmentOrder> longest_agreeing(std::span<const SegmentOrder> segments,
                                               std::span<const ErrorSample> without_error, bool prefer_last) {
  for (std::size_t length = segments.size(); length >= 2; --length) {
    const std::size_t last_start = segments.size() - length;
    for (std::size_t k = 0; k <= last_start; ++k) {
      const auto run = segments.subspan(prefer_last ? last_start - k : k, length);
      if (agree(run, without_error)) return run;
    }
  }
  return {};
}

}  // namespace

std::vector<ErrorSample> usable_samples(std::span<const ErrorSample> samples, double from, double to) {
  std::vector<ErrorSample> chosen = samples_within(samples, from, to);
  std::erase_if(chosen, [](const ErrorSample& s) { return !has_error(s); });
  return chosen;
}

std::vector<ErrorSample> samples_within(std::span<const ErrorSample> samples, double from, double to) {
  if (!(from <= to))
    throw support::UsageError(
        fmt::format("fit window from {} to {} is empty (from must not be greater than to)", from, to));
  const Window window{from, to};
  std::vector<ErrorSample> chosen;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(chosen),
               [&](const ErrorSample& s) { return usable(s) && window.holds(s.x); });
  std::stable_sort(chosen.begin(), chosen.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return chosen;
}

ObservedOrder fit_order(std::span<const ErrorSample> samples, double from, double to) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<ErrorSample> all = usable_samples(samples, -infinity, infinity);
  const std::vector<ErrorSample> fitted = usable_samples(samples, from, to);

  ObservedOrder result;
  result.from = from;
  result.to = to;
  result.points = static_cast<int>(fitted.size());
  if (have_different_h(fitted)) {
    const Line line = fit_line(fitted);
    result.order = line.slope;
    result.constant = std::exp(line.intercept);
    result.r_squared = line.r_squared;
    if (fitted.size() >= 4) result.half_width = student_t_95(static_cast<double>(fitted.size() - 2)) * line.slope_error;
  }

  std::vector<ErrorSample> without_error;
  std::ranges::copy_if(samples, std::back_inserter(without_error), [](const auto& s) { return !has_error(s); });
  result.segments = segment_orders(all);
  result.asymptotic = agree(window_segments(result), without_error);
  const bool finest_last = !all.empty() && all.back().h < all.front().h;
  if (const auto run = longest_agreeing(result.segments, without_error, finest_last); !run.empty()) {
    result.asymptotic_from = run.front().from;
    result.asymptotic_to = run.back().to;
  }
  return result;
}

double half_width(const ObservedOrder& fit) {
  if (fit.replicates && !std::isnan(fit.replicates->half_width)) return fit.replicates->half_width;
  if (!std::isnan(fit.half_width)) return fit.half_width;
  return fit.points == 3 ? segment_spread(fit) / 2 : 0;
}

std::string asymptotic_word(const ObservedOrder& fit) {
  if (!fit.asymptotic) return "no";
  if (fit.order > asymptotic_spread) return "yes";
  return fit.order < -asymptotic_spread ? "grows" : "stays";
}

double finest_segment(const ObservedOrder& fit, bool finest_last) {
  const auto segments = window_segments(fit);
  if (segments.empty()) return not_measured;
  return finest_last ? segments.back().order : segments.front().order;
}

double segment_spread(const ObservedOrder& fit) {
  const auto segments = window_segments(fit);
  if (segments.empty()) return 0;
  const auto [lowest, highest] = std::ranges::minmax_element(segments, {}, &SegmentOrder::order);
  return highest->order - lowest->order;
}

}  // namespace mpmvv::fits
