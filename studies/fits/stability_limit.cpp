#include "studies/fits/stability_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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

/// The verdicts of a batch, without repeats: several values may lead to the same run.
std::vector<Probe> ask(const ProbeBatch& probe, const std::vector<double>& values) {
  std::vector<Probe> answer = probe(values);
  if (answer.size() != values.size())
    throw std::logic_error(fmt::format("{} values probed, {} verdicts given", values.size(), answer.size()));
  const auto repeated = std::ranges::unique(answer, {}, &Probe::value);
  answer.erase(repeated.begin(), repeated.end());
  return answer;
}

bool is_unstable(const Probe& p) {
  return !p.stable;
}

/// Bisects the bracket at its geometric mean until it is narrow enough, or no run lies inside.
void bisect(StabilityLimit& limit, double tolerance, const ProbeBatch& probe) {
  while (std::abs(limit.unstable - limit.stable) > tolerance * limit.stable) {
    const auto [low, high] = std::minmax(limit.stable, limit.unstable);
    const double middle = std::sqrt(limit.stable) * std::sqrt(limit.unstable);
    const Probe next = ask(probe, {middle}).front();
    if (next.value <= low || next.value >= high) return;
    limit.probes.push_back(next);
    (next.stable ? limit.stable : limit.unstable) = next.value;
  }
}

}  // namespace

StabilityLimit find_limit(const LimitSearch& search, const ProbeBatch& probe) {
  require_sound(search);
  StabilityLimit limit;
  limit.key = search.key;
  limit.probes = ask(probe, scan_values(search));

  std::vector<Probe> scan = limit.probes;
  if (!search.stable_below) std::reverse(scan.begin(), scan.end());
  const auto first_unstable = std::find_if(scan.begin(), scan.end(), is_unstable);
  limit.monotone = std::all_of(first_unstable, scan.end(), is_unstable);
  if (first_unstable != scan.end()) limit.unstable = first_unstable->value;
  if (first_unstable != scan.begin()) limit.stable = std::prev(first_unstable)->value;
  limit.found = first_unstable != scan.begin() && first_unstable != scan.end();

  if (limit.found) bisect(limit, search.tolerance, probe);
  std::sort(limit.probes.begin(), limit.probes.end(), [](const Probe& a, const Probe& b) { return a.value < b.value; });
  return limit;
}

StabilityLimit common_limit(const std::vector<StabilityLimit>& replicates) {
  const StabilityLimit& first = replicates.front();
  const auto found = std::ranges::find(replicates, true, &StabilityLimit::found);
  const bool stable_below = found == replicates.end() || found->stable < found->unstable;
  const auto least = [](double a, double b) { return std::isnan(b) || b < a ? b : a; };
  const auto largest = [](double a, double b) { return std::isnan(b) || b > a ? b : a; };
  StabilityLimit common = first;
  for (const StabilityLimit& one : std::span(replicates).subspan(1)) {
    common.stable = stable_below ? least(common.stable, one.stable) : largest(common.stable, one.stable);
    common.unstable = stable_below ? largest(common.unstable, one.unstable) : least(common.unstable, one.unstable);
    const bool agrees = one.found == first.found && std::isnan(one.stable) == std::isnan(first.stable);
    common.monotone = common.monotone && one.monotone && agrees;
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
