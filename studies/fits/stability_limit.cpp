#include "studies/fits/stability_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <stdexcept>

#include "studies/support/error.hpp"

namespace mpmvv::fits {
namespace {

constexpr double most_scan_steps = 1000;
constexpr double least_tolerance = 1e-9;

double scan_steps(const LimitSearch& search) {
  return std::max(1.0, std::ceil(std::log(search.to / search.from) / std::log(search.scan_ratio) - 1e-9));
}

}  // namespace

void require_sound(const LimitSearch& search) {
  const auto reject = [&](const std::string& what) {
    throw support::UsageError(fmt::format("limit search of '{}': {}", search.key, what));
  };
  if (!(search.from > 0) || !std::isfinite(search.from))
    reject(fmt::format("from = {} (must be positive and finite)", search.from));
  if (!(search.to > search.from) || !std::isfinite(search.to))
    reject(fmt::format("to = {} (must be finite and greater than from = {})", search.to, search.from));
  if (!(search.scan_ratio > 1) || !std::isfinite(search.scan_ratio))
    reject(fmt::format("scan_ratio = {} (must be finite and greater than 1)", search.scan_ratio));
  if (!(search.tolerance >= least_tolerance && search.tolerance < 1))
    reject(fmt::format("tolerance = {} (must be at least {} and less than 1)", search.tolerance, least_tolerance));
  if (!(scan_steps(search) <= most_scan_steps))
    reject(fmt::format("scan_ratio = {} makes more than {} steps from {} to {} (take a greater one)", search.scan_ratio,
                       most_scan_steps, search.from, search.to));
}

std::vector<double> scan_values(const LimitSearch& search) {
  const double steps = scan_steps(search);
  std::vector<double> values;
  for (double k = 0; k < steps; ++k) values.push_back(search.from * std::pow(search.to / search.from, k / steps));
  values.push_back(search.to);
  return values;
}

namespace {

bool is_unstable(const Probe& p) {
  return !p.stable;
}

/// A search under way. Its probes are in increasing value, each once: several values may lead to the same run.
class Search {
 public:
  Search(const LimitSearch& search, const ProbeBatch& probe) : search_(search), probe_(probe) {}

  void ask(const std::vector<double>& values) {
    const std::vector<Probe> answer = probe_(values);
    if (answer.size() != values.size())
      throw std::logic_error(fmt::format("{} values probed, {} verdicts given", values.size(), answer.size()));
    for (const Probe& one : answer)
      if (const auto at = std::ranges::lower_bound(probes_, one.value, {}, &Probe::value);
          at == probes_.end() || at->value != one.value)
        probes_.insert(at, one);
  }

  /// What the probes say so far: the first unstable one from the stable end, and its neighbour.
  StabilityLimit first_bracket() const {
    StabilityLimit limit{.key = search_.key, .probes = probes_};
    const std::vector<Probe> from_stable = from_stable_end();
    const auto unstable = std::ranges::find_if(from_stable, is_unstable);
    limit.monotone = std::all_of(unstable, from_stable.end(), is_unstable);
    if (unstable != from_stable.end()) limit.unstable = unstable->value;
    if (unstable != from_stable.begin()) limit.stable = std::prev(unstable)->value;
    limit.found = unstable != from_stable.begin() && unstable != from_stable.end();
    return limit;
  }

  /// Bisects the first bracket.
  void bisect() { bisect(&Search::first_bracket); }

  /// Bisects the end of the whole bracket that is not that of the first one.
  void bisect_far_end() { bisect(&Search::last_bracket); }

  void probe_around(const StabilityLimit& limit) {
    std::vector<double> values;
    for (const double distance : {1, 2, 5}) {
      const double factor = 1 + distance * search_.tolerance;
      if (factor >= search_.scan_ratio) continue;  // the scan has been there
      const auto [low, high] = std::minmax(limit.stable, limit.unstable);
      if (low / factor > search_.from) values.push_back(low / factor);
      if (high * factor < search_.to) values.push_back(high * factor);
    }
    if (!values.empty()) ask(values);
  }

  /// The first bracket, but to the first value from which no probe is stable.
  StabilityLimit whole_bracket() const {
    StabilityLimit limit = first_bracket();
    if (limit.monotone) return limit;
    limit.unstable = last_bracket().unstable;
    limit.found = limit.found && !std::isnan(limit.unstable);
    return limit;
  }

 private:
  const LimitSearch& search_;
  const ProbeBatch& probe_;
  std::vector<Probe> probes_;

  /// The last stable probe from the stable end, and its neighbour.
  StabilityLimit last_bracket() const {
    const std::vector<Probe> from_stable = from_stable_end();
    const auto end = from_stable.rend();
    const auto stable = std::find_if_not(from_stable.rbegin(), end, is_unstable);
    StabilityLimit limit;
    if (stable != end) limit.stable = stable->value;
    if (stable != from_stable.rbegin()) limit.unstable = std::prev(stable)->value;
    return limit;
  }

  /// Bisects a bracket at its geometric mean until it is narrow enough, or no run lies inside.
  void bisect(StabilityLimit (Search::*bracket)() const) {
    for (StabilityLimit limit = (this->*bracket)(); is_wide(limit); limit = (this->*bracket)()) {
      const std::size_t known = probes_.size();
      ask({std::sqrt(limit.stable) * std::sqrt(limit.unstable)});
      if (probes_.size() == known) return;
    }
  }

  /// Not so where an end is not known.
  bool is_wide(const StabilityLimit& limit) const {
    return std::abs(limit.unstable - limit.stable) > search_.tolerance * limit.stable;
  }

  std::vector<Probe> from_stable_end() const {
    std::vector<Probe> probes = probes_;
    if (!search_.stable_below) std::ranges::reverse(probes);
    return probes;
  }
};

}  // namespace

StabilityLimit find_limit(const LimitSearch& search, const ProbeBatch& probe) {
  require_sound(search);
  Search under_way(search, probe);
  under_way.ask(scan_values(search));
  bool is_moving = under_way.first_bracket().found;
  while (is_moving) {
    under_way.bisect();
    const StabilityLimit bracket = under_way.first_bracket();
    under_way.probe_around(bracket);
    is_moving = under_way.first_bracket().unstable != bracket.unstable;
  }
  if (!under_way.first_bracket().monotone) under_way.bisect_far_end();
  return under_way.whole_bracket();
}

std::int64_t steps_at_limit(const StabilityLimit& limit) {
  const auto stable = std::ranges::find(limit.probes, limit.stable, &Probe::value);
  return stable == limit.probes.end() ? 0 : stable->steps;
}

double least_visible_growth(std::int64_t steps) {
  return steps > 0 ? std::pow(10, 12 / static_cast<double>(steps)) : support::not_measured;
}

std::string too_few_steps(const StabilityLimit& limit) {
  const std::int64_t steps = steps_at_limit(limit);
  if (steps == 0 || steps >= enough_steps) return "";
  return fmt::format("only {} {} at {:.4g}, where growth that doubles on each shows from {} on", steps,
                     steps == 1 ? "step" : "steps", limit.stable, enough_steps);
}

bool LimitRange::is_open() const {
  return lower == 0 || std::isinf(upper);
}

std::optional<LimitRange> range_of(const StabilityLimit& limit) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (limit.found) {
    const auto [lower, upper] = std::minmax(limit.stable, limit.unstable);
    return LimitRange{lower, upper, limit.stable < limit.unstable};
  }
  const bool ends_stable = !std::isnan(limit.stable);
  const double end = ends_stable ? limit.stable : limit.unstable;
  const auto differs = [&](const Probe& p) { return p.stable != ends_stable; };
  const auto is_above = [&](const Probe& p) { return p.value > end; };
  const auto is_below = [&](const Probe& p) { return p.value < end; };
  const bool any_differs = std::ranges::any_of(limit.probes, differs);
  const bool is_one_value = std::ranges::none_of(limit.probes, [&](const Probe& p) { return p.value != end; });
  if (std::isnan(end) || is_one_value) return std::nullopt;
  // The limit lies on the side of the probes that differ from this end, or else where nothing was tried.
  const bool lies_above = any_differs
                              ? std::ranges::any_of(limit.probes, [&](auto& p) { return differs(p) && is_above(p); })
                              : std::ranges::any_of(limit.probes, is_below);
  return lies_above ? LimitRange{end, infinity, ends_stable} : LimitRange{0, end, !ends_stable};
}

std::optional<LimitRange> sure_range_of(const StabilityLimit& limit) {
  auto range = range_of(limit);
  if (!range || std::isnan(limit.stable) || too_few_steps(limit).empty()) return range;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double end = range->stable_below ? 0 : infinity;
  for (const Probe& p : limit.probes) {
    const bool is_beyond = range->stable_below ? p.value > limit.stable : p.value < limit.stable;
    const bool has_too_few = p.steps > 0 && p.steps < enough_steps;
    if (!p.stable || is_beyond || has_too_few) continue;
    end = range->stable_below ? std::max(end, p.value) : std::min(end, p.value);
  }
  (range->stable_below ? range->lower : range->upper) = end;
  if (range->lower == 0 && std::isinf(range->upper)) return std::nullopt;
  return range;
}

StabilityLimit common_limit(const std::vector<StabilityLimit>& replicates, bool stable_below) {
  const auto least = [](double a, double b) { return std::isnan(b) || b < a ? b : a; };
  const auto largest = [](double a, double b) { return std::isnan(b) || b > a ? b : a; };
  StabilityLimit common = replicates.front();
  for (const StabilityLimit& one : std::span(replicates).subspan(1)) {
    common.stable = stable_below ? least(common.stable, one.stable) : largest(common.stable, one.stable);
    common.unstable = stable_below ? largest(common.unstable, one.unstable) : least(common.unstable, one.unstable);
    common.monotone = common.monotone && one.monotone;
    common.found = common.found && one.found;
    common.probes.insert(common.probes.end(), one.probes.begin(), one.probes.end());
  }
  std::ranges::stable_sort(common.probes, {}, &Probe::value);
  return common;
}

namespace {

/// Whether runs at the same value have ended differently. The probes are sorted, so such runs are neighbours.
bool do_replicates_disagree(const std::vector<Probe>& probes) {
  return std::ranges::adjacent_find(probes, [](const Probe& a, const Probe& b) {
           return a.value == b.value && a.stable != b.stable;
         }) != probes.end();
}

}  // namespace

std::string text_without_limit(const StabilityLimit& limit) {
  if (limit.probes.empty()) return "nothing tried";
  const bool is_unstable_once = std::ranges::any_of(limit.probes, is_unstable);
  if (is_unstable_once && !std::ranges::all_of(limit.probes, is_unstable))
    return do_replicates_disagree(limit.probes) ? "replicates disagree"
                                                : "stable at some of the values tried, unstable at others";
  const double farthest = is_unstable_once ? limit.unstable : limit.stable;
  return fmt::format("{} at all values tried, {} to {:.4g}", is_unstable_once ? "unstable" : "stable",
                     farthest < limit.probes.back().value ? "down" : "up", farthest);
}

}  // namespace mpmvv::fits
