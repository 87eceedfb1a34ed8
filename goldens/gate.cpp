#include "goldens/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "studies/error.hpp"
#include "studies/observed_order.hpp"

namespace mpmvv {

namespace {

struct Judgement {
  Verdict verdict;
  std::string measured, reason;
  bool better = false;
};

Judgement pass(std::string measured) {
  return {Verdict::pass, std::move(measured), ""};
}
Judgement fail(std::string measured, std::string reason) {
  return {Verdict::fail, std::move(measured), std::move(reason)};
}
Judgement better(std::string measured, std::string reason) {
  return {Verdict::fail, std::move(measured), std::move(reason), true};
}
Judgement inconclusive(std::string measured, std::string reason) {
  return {Verdict::inconclusive, std::move(measured), std::move(reason)};
}
Judgement missing(const std::string& what) {
  return inconclusive("", "missing: " + what);
}

template <class Element, class Wanted, class Projection>
const Element* find(const std::vector<Element>& elements, const Wanted& wanted, Projection projection) {
  const auto found = std::ranges::find(elements, wanted, projection);
  return found == elements.end() ? nullptr : &*found;
}

bool same_swept_value(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}

const Point* find_point(const Series& series, double at) {
  const auto found = std::ranges::find_if(series.points, [&](const Point& p) { return same_swept_value(p.x, at); });
  return found == series.points.end() ? nullptr : &*found;
}

std::string status_text(const Point& point) {
  return point.reason.empty() ? to_string(point.status) : fmt::format("{}: {}", to_string(point.status), point.reason);
}

/// How many points of the fit's window are no results, so that a shrunken window is seen.
std::string order_text(const ObservedOrder& fit, const Series& series) {
  const auto lost = std::ranges::count_if(
      series.points, [&](const Point& p) { return p.status != Status::ok && fit.from <= p.x && p.x <= fit.to; });
  const std::string loss = lost > 0 ? fmt::format(", {} unstable or failed", lost) : "";
  return fmt::format("{:.6g} ({} points{})", fit.order, fit.points, loss);
}

const ObservedOrder* find_order(const OrderGolden& golden, const Series& series) {
  const auto& window = golden.window;
  const auto found = std::ranges::find_if(series.orders, [&](const ObservedOrder& fit) {
    return fit.norm == golden.norm &&
           (window.empty() || (same_swept_value(fit.from, window[0]) && same_swept_value(fit.to, window[1])));
  });
  return found == series.orders.end() ? nullptr : &*found;
}

/// Whether the error at the finest level has grown by more than its band: an order can hold all the same.
bool has_grown(const OrderGolden& golden, const Series& series) {
  if (golden.finest.empty()) return false;
  const Point* point = find_point(series, golden.finest[0]);
  if (!point || !point->y.contains(golden.norm)) return false;
  return point->y.at(golden.norm) > golden.finest[1] * (1 + error_band);
}

/// How far the segment orders inside the fit's window lie from each other.
double segment_spread(const ObservedOrder& fit) {
  double least = INFINITY, most = -INFINITY;
  for (const SegmentOrder& s : fit.segments)
    if (s.from >= fit.from && s.to <= fit.to) least = std::min(least, s.order), most = std::max(most, s.order);
  return most - least;
}

/// An order inside the band, or outside it with an interval that reaches in.
Judgement judge_interval(const OrderGolden& golden, const ObservedOrder& fit, const std::string& measured) {
  const double width = half_width(fit),
               widest = std::max(golden.upper - golden.lower, interval_margin * golden.interval);
  if (fit.order < golden.lower || fit.order > golden.upper)
    return inconclusive(measured, fmt::format("outside the band, but its interval of ± {:.2g} reaches in", width));
  if (width > widest) return inconclusive(measured, fmt::format("its interval of ± {:.2g} is too wide", width));
  const bool scattered = segment_spread(fit) > 2 * asymptotic_spread;  // twice: what just was may just be no more
  if (golden.asymptotic && scattered) return inconclusive(measured, "the window is not asymptotic any more");
  return pass(measured);
}

Judgement judge(const OrderGolden& golden, const Series& series) {
  constexpr double absurd = 1;  // above any band: no scatter brings an order there
  const ObservedOrder* fit = find_order(golden, series);
  if (!fit) return missing(fmt::format("no order of '{}' in {} over that window", golden.series, golden.norm));
  const std::string measured = order_text(*fit, series);
  if (std::isnan(fit->order)) return inconclusive(measured, "no order could be fitted");
  if (fit->points < 3) return inconclusive(measured, "fewer than 3 usable points in the window");
  if (fit->points < golden.points) return fail(measured, fmt::format("fewer usable points than {}", golden.points));
  const double width = half_width(*fit);
  if (fit->order + width < golden.lower) return fail(measured, "order below the golden's band");
  if (fit->order > golden.upper + absurd) return fail(measured, "order absurdly high");
  if (fit->order - width > golden.upper) return better(measured, "order above the golden's band");
  if (has_grown(golden, series))
    return fail(measured,
                fmt::format("the order holds, but the error at {:g} is larger than {:.4g} by more than {:g} %",
                            golden.finest[0], golden.finest[1], 100 * error_band));
  return judge_interval(golden, *fit, measured);
}

Judgement judge(const ErrorGolden& golden, const Series& series) {
  const Point* point = find_point(series, golden.at);
  if (!point) return missing(fmt::format("no point of '{}' at {}", golden.series, golden.at));
  if (point->status != Status::ok) return fail(status_text(*point), "no error: the run is not ok");
  const auto entry = point->y.find(golden.norm);
  if (entry == point->y.end()) return missing(fmt::format("no {} of '{}'", golden.norm, golden.series));
  const double error = entry->second;
  const std::string measured = fmt::format("{:.6g}", error);
  if (std::isnan(error)) return inconclusive(measured, "the error was not measured");
  if (error > golden.expected * (1 + golden.band)) return fail(measured, "error larger than the golden's band");
  if (error < golden.expected * (1 - golden.band)) return better(measured, "better than the golden: propose a new one");
  return pass(measured);
}

struct Band {
  double lower, upper;
  bool contains(double x) const { return lower <= x && x <= upper; }
};

/// All probes agree, so the limit lies outside what was scanned: a failure when the scan covers the whole band.
Judgement judge_unfound(const StabilityLimit& limit, const Band& band) {
  if (limit.probes.empty()) return inconclusive("", "limit not found: no probes");
  if (!limit.monotone) return inconclusive("", "limit not found: stability is not monotone");
  const auto [first, last] = std::ranges::minmax(limit.probes, {}, &Probe::value);
  const std::string measured =
      fmt::format("all {} from {:.6g} to {:.6g}", first.stable ? "stable" : "unstable", first.value, last.value);
  if (first.value <= band.lower && band.upper <= last.value) return fail(measured, "no limit inside the golden's band");
  return inconclusive(measured, "limit not found");
}

Judgement judge(const LimitGolden& golden, const Series& series) {
  if (!series.limit) return missing(fmt::format("no limit of '{}'", golden.series));
  const StabilityLimit& limit = *series.limit;
  const Band band{golden.expected * (1 - golden.band), golden.expected * (1 + golden.band)};
  if (!limit.found) return judge_unfound(limit, band);

  const auto [low, high] = std::minmax(limit.stable, limit.unstable);
  const std::string measured = fmt::format("{:.6g} in [{:.6g}, {:.6g}]", limit.value(), low, high);
  if (high < band.lower)
    return {Verdict::fail, measured, "limit below the golden's band", limit.key == "smoothing_length"};
  if (low > band.upper)
    return {Verdict::fail, measured, "limit above the golden's band", limit.key != "smoothing_length"};
  if (!limit.monotone) return inconclusive(measured, "stability is not monotone");
  if (!band.contains(limit.value())) return inconclusive(measured, "the bracket straddles the edge of the band");
  if (high - low > band.upper - band.lower) return inconclusive(measured, "the bracket is wider than the band");
  return pass(measured);
}

Judgement judge(const StatusGolden& golden, const Series& series) {
  const Point* point = find_point(series, golden.at);
  if (!point) return missing(fmt::format("no point of '{}' at {}", golden.series, golden.at));
  const std::string measured = status_text(*point);
  return point->status == golden.expected ? pass(measured) : fail(measured, "another status than the golden's");
}

Judgement judge(const ValueGolden& golden, const StudyResult& study) {
  const Value* value = find(study.values, golden.name, &Value::name);
  if (!value) return missing(fmt::format("no value '{}'", golden.name));
  const std::string measured = fmt::format("{:.6g}", value->value);
  if (std::isnan(value->value)) return inconclusive(measured, "the value was not measured");
  if (value->value > golden.upper) return fail(measured, "value above the golden's bound");
  if (value->value < golden.lower) return fail(measured, "value below the golden's bound");
  return pass(measured);
}

template <class OfSeries>
Judgement judge(const OfSeries& golden, const StudyResult& study) {
  const Series* series = find(study.series, golden.series, &Series::name);
  return series ? judge(golden, *series) : missing(fmt::format("no series '{}'", golden.series));
}

GateResult judge(const Golden& golden, const std::vector<StudyResult>& studies) {
  const StudyResult* study = find(studies, golden.study, &StudyResult::name);
  Judgement judgement =
      study ? std::visit([&](const auto& expectation) { return judge(expectation, *study); }, golden.expectation)
            : missing(fmt::format("no study '{}' in the store", golden.study));
  return {golden.study,
          subject(golden),
          judgement.verdict,
          expected_text(golden),
          std::move(judgement.measured),
          std::move(judgement.reason),
          golden.where,
          judgement.better};
}

}  // namespace

int GateReport::count(Verdict v) const {
  return static_cast<int>(std::ranges::count(results, v, &GateResult::verdict));
}

int GateReport::exit_code() const {
  if (count(Verdict::fail) > 0) return 1;
  return count(Verdict::inconclusive) > 0 ? 3 : 0;
}

GateReport run_gate(const std::vector<Golden>& goldens, const std::vector<StudyResult>& studies,
                    const std::vector<std::string>& only) {
  if (goldens.empty()) throw UsageError("no golden to judge (at least one)");
  for (const std::string& study : only) {
    if (!find(goldens, study, &Golden::study)) {
      throw UsageError(fmt::format("no golden for study '{}' (a study with goldens)", study));
    }
  }
  GateReport report;
  for (const Golden& golden : goldens) {
    if (only.empty() || std::ranges::count(only, golden.study) > 0) report.results.push_back(judge(golden, studies));
  }
  return report;
}

}  // namespace mpmvv
