#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "goldens/judgement.hpp"
#include "studies/fits/observed_order.hpp"
#include "studies/fits/window.hpp"

namespace mpmvv::goldens {

using fits::same_level;

using fits::ObservedOrder;
using records::Point;
using records::Series;

namespace {

/// The points of a series in the fit's window, usable or not.
std::vector<const Point*> window_of(const ObservedOrder& fit, const Series& series) {
  std::vector<const Point*> points;
  for (const Point& point : series.points)
    if (fits::Window{fit.from, fit.to}.holds(point.x)) points.push_back(&point);
  return points;
}

/// The order, and how many points it is fitted to and how many of its window are no results, so that a shrunken window
/// is seen. Empty where none could be fitted.
std::string order_text(const ObservedOrder& fit, const Series& series) {
  if (std::isnan(fit.order)) return "";
  const auto lost =
      std::ranges::count_if(window_of(fit, series), [](const Point* p) { return p->status != records::Status::ok; });
  const std::string loss = lost > 0 ? fmt::format(", {} unstable or failed", lost) : "";
  return fmt::format("{:.6g} ({} points{})", fit.order, fit.points, loss);
}

/// Whether the golden leaves open which of several orders it is of: another one in the study file would change that.
bool is_ambiguous(const OrderGolden& golden, const Series& series) {
  return golden.window.empty() && std::ranges::count(series.orders, golden.norm, &ObservedOrder::norm) > 1;
}

const ObservedOrder* find_order(const OrderGolden& golden, const Series& series) {
  const auto& window = golden.window;
  const auto found = std::ranges::find_if(series.orders, [&](const ObservedOrder& fit) {
    return fit.norm == golden.norm &&
           (window.empty() || (same_level(fit.from, window[0]) && same_level(fit.to, window[1])));
  });
  return found == series.orders.end() ? nullptr : &*found;
}

/// What the series lacks of the levels that the golden names: its finest one and the ends of its window. The curve of a
/// check has no levels; the ends of its window need not be among its points.
std::optional<Judgement> lacking_level(const OrderGolden& golden, const ObservedOrder& fit, const Series& series) {
  if (golden.norm != "y")
    for (const double end : {fit.from, fit.to})
      if (!find_point(series, end)) return lacking(series, golden.norm, end);
  return golden.finest.empty() ? std::nullopt : lacking(series, golden.norm, golden.finest[0]);
}

/// Whether the error at the finest level has grown by more than its band: an order can hold all the same, and rises
/// where the errors at coarser levels have grown more.
bool has_grown(const OrderGolden& golden, const Series& series) {
  return !golden.finest.empty() &&
         find_point(series, golden.finest[0])->y.at(golden.norm) > golden.finest[1] * (1 + error_band);
}

/// Fails an order of too few points: with the runs that were lost, and where an order is left with how many it needs.
Judgement fail_by_lost_points(const OrderGolden& golden, const ObservedOrder& fit, const Series& series, int wanted) {
  const std::string measured = order_text(fit, series), few = fmt::format("fewer usable points than {}", wanted);
  LostRuns lost = lost_runs(window_of(fit, series), golden.finest.empty() ? fits::not_measured : golden.finest[0]);
  if (lost.text.empty()) return fail(measured, few);
  if (!measured.empty()) lost.text = few + ": " + lost.text;
  return fail(measured, lost);
}

/// Judges an order that is inside the band, or outside it with an interval that reaches in.
Judgement judge_interval(const OrderGolden& golden, const ObservedOrder& fit, const std::string& measured) {
  const double width = fits::half_width(fit),
               widest = std::max(golden.upper - golden.lower, interval_margin * golden.interval);
  if (fit.order < golden.lower || fit.order > golden.upper)
    return inconclusive(measured, fmt::format("outside the band, but its interval of ± {:.2g} reaches in", width));
  if (width > widest) return inconclusive(measured, fmt::format("its interval of ± {:.2g} is too wide", width));
  // Twice the spread, so that a window that only just was asymptotic may now just miss it.
  const bool scattered = fits::segment_spread(fit) > 2 * fits::asymptotic_spread;
  if (golden.asymptotic && scattered) return inconclusive(measured, "the window is not asymptotic any more");
  return pass(measured);
}

}  // namespace

Judgement judge(const OrderGolden& golden, const Series& series) {
  constexpr double absurd = 1;  // above any band: no scatter brings an order there
  if (is_ambiguous(golden, series))
    return inconclusive(
        "", fmt::format("'{}' has orders in {} over several windows (window = [FROM, TO] in the golden)", golden.series,
                        golden.norm));
  const ObservedOrder* fit = find_order(golden, series);
  if (!fit) return missing(fmt::format("no order of '{}' in {} over that window", golden.series, golden.norm));
  const std::string measured = order_text(*fit, series);
  const int wanted = golden.points > 0 ? golden.points : static_cast<int>(window_of(*fit, series).size());
  if (fit->points < wanted) return fail_by_lost_points(golden, *fit, series, wanted);
  if (std::isnan(fit->order)) return inconclusive(measured, "no order could be fitted");
  if (fit->points < 3) return inconclusive(measured, "fewer than 3 usable points in the window");
  const double width = fits::half_width(*fit);
  if (fit->order + width < golden.lower) return fail(measured, "order below the golden's band");
  if (fit->order > golden.upper + absurd) return fail(measured, "order absurdly high");
  if (auto lack = lacking_level(golden, *fit, series)) {
    lack->measured = measured;
    return *lack;
  }
  if (has_grown(golden, series))
    return fail(measured, fmt::format("the error at {:g} is larger than {:.4g} by more than {:g} %, whatever the order",
                                      golden.finest[0], golden.finest[1], 100 * error_band));
  if (fit->order - width > golden.upper) return fail_as_better(measured, "order above the golden's band");
  return judge_interval(golden, *fit, measured);
}

}  // namespace mpmvv::goldens
