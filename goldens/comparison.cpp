#include "goldens/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "goldens/golden.hpp"
#include "studies/claims/claim.hpp"

namespace mpmvv::goldens {

using claims::Finding;

namespace {

/// What makes a finding the same in two versions: its study, its name, the studies that judge it, and how many findings
/// with all of these come before it.
struct Key {
  std::string study, name;
  std::set<std::string> judges;
  std::size_t place;

  auto operator<=>(const Key&) const = default;
};

using ByKey = std::map<Key, const Finding*>;

/// The findings, each with its key, in their order.
std::vector<std::pair<Key, const Finding*>> with_keys(const std::vector<Finding>& findings) {
  std::map<Key, std::size_t> count;
  std::vector<std::pair<Key, const Finding*>> all;
  for (const Finding& finding : findings) {
    Key key{finding.study, finding.name, {finding.judges.begin(), finding.judges.end()}, 0};
    key.place = count[key]++;
    all.emplace_back(std::move(key), &finding);
  }
  return all;
}

/// Whether two numbers are the same up to round-off. Infinity is the same as itself alone, and so is what is no number.
bool same_up_to_round_off(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return a == b || (std::isnan(a) && std::isnan(b));
  const double size = std::max(std::abs(a), std::abs(b));
  return size <= absolute_round_off || std::abs(a - b) <= relative_round_off * size;
}

/// How much a word (a status, a verdict) that differs counts, in bands, and a number that is infinite in one version:
/// more than any number.
constexpr double beyond_any_number = std::numeric_limits<double>::infinity();

/// The size of a change in widths of the goldens' band for this kind of number.
double bands_between(Finding::Kind kind, double before, double after) {
  if (same_up_to_round_off(before, after)) return 0;
  if (!std::isfinite(before) || !std::isfinite(after)) return beyond_any_number;
  const double step = std::abs(after - before);
  if (kind == Finding::Kind::order) return step / order_band;
  const double size = std::abs(before == 0 ? after : before);
  return step / size / (kind == Finding::Kind::limit ? limit_band : error_band);
}

/// For an extrapolated value the band is its uncertainty.
double bands_between(const Finding& before, const Finding& after) {
  if (before.uncertainty > 0 && !same_up_to_round_off(before.number, after.number))
    return std::abs(after.number - before.number) / before.uncertainty;
  return bands_between(before.kind, before.number, after.number);
}

/// The largest size of a finite value on the curve in either version.
double size_of_curve(const Change& change) {
  double size = 0;
  for (const auto* levels : {&change.before.levels, &change.after.levels})
    for (const Finding::Level& level : *levels)
      if (std::isfinite(level.y)) size = std::max(size, std::abs(level.y));
  return size;
}

/// The level with the largest change among those that both have. A curve may cross 0, so its steps are measured against
/// the whole curve.
void compare_levels(Change& change) {
  const auto& a = change.before.levels;
  const auto& b = change.after.levels;
  const double size = is_curve(change.before) ? size_of_curve(change) : 0;
  const auto between = [size](double before, double after) {
    if (size == 0 || !std::isfinite(after - before)) return bands_between(Finding::Kind::error, before, after);
    return same_up_to_round_off(before, after) ? 0 : std::abs(after - before) / size / error_band;
  };
  double most = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i].x == b[j].x) {
      const double bands = between(a[i].y, b[j].y);
      if (bands > most) {
        most = bands;
        change.largest = {a[i].x, a[i].y, b[j].y};
      }
      ++i, ++j;
    } else {
      ++(a[i].x < b[j].x ? i : j);
    }
  }
  if (most == 0) return;
  // An energy loss is below 0 where energy was gained: of errors the sizes say which one is better.
  const double growth = std::abs(change.largest->after) - std::abs(change.largest->before);
  const bool better = change.before.better * growth > 0;
  change.bands = better ? -most : most;
}

/// The words of statuses and verdicts, the better ones higher. A word without a rank says neither good nor bad:
/// `shown`, or why there is no number.
std::optional<int> rank_of(const std::string& word) {
  using Claim = claims::Claim::Verdict;
  using Part = records::PartVerdict;
  using records::Status;
  static const std::map<std::string, int> ranks{{to_string(Status::ok), 3},         {to_string(Status::unstable), 2},
                                                {to_string(Status::failed), 1},     {to_string(Part::holds), 3},
                                                {to_string(Part::inconclusive), 2}, {to_string(Part::fails), 1},
                                                {to_string(Claim::confirmed), 4},   {to_string(Claim::partly), 3},
                                                {to_string(Claim::open), 2},        {to_string(Claim::refuted), 1}};
  const auto found = ranks.find(word);
  return found == ranks.end() ? std::nullopt : std::optional(found->second);
}

/// Of limits the best lies beyond all that was tried and stable, the worst where nothing was stable.
bool is_improvement(const Finding& before, const Finding& after) {
  if (before.side != after.side) return after.side > before.side;
  const auto was = rank_of(before.word), is = rank_of(after.word);
  return after.word.empty() || (was && is && *is > *was);
}

Change change_between(const Finding& before, const Finding& after) {
  Change change{before, after, {}, 0};
  const bool only_tried_elsewhere = before.side != 0 && before.side == after.side;
  if (before.word != after.word && !only_tried_elsewhere) {
    change.bands = is_improvement(before, after) ? -beyond_any_number : beyond_any_number;
  } else if (!before.levels.empty()) {
    compare_levels(change);
  } else if (before.word.empty()) {
    const double bands = bands_between(before, after);
    change.bands = before.better * (after.number - before.number) > 0 ? -bands : bands;
  }
  return change;
}

/// The findings that the other version lacks: "study: finding", or the study's name alone where it is missing as a
/// whole. Of the verdict on a claim that other studies judge there, these are told.
std::vector<std::string> only_in(const std::vector<std::pair<Key, const Finding*>>& findings, const ByKey& others) {
  std::set<std::string> studies, claims;
  for (const auto& [key, finding] : others) key.study.empty() ? claims.insert(key.name) : studies.insert(key.study);
  std::vector<std::string> only;
  for (const auto& [key, finding] : findings) {
    if (others.contains(key)) continue;
    std::string what = "study " + key.study;
    if (key.study.empty())
      what = key.name + (claims.contains(key.name) ? fmt::format(" by {}", fmt::join(key.judges, ", ")) : "");
    else if (studies.contains(key.study))
      what = key.study + ": " + key.name;
    if (only.empty() || only.back() != what) only.push_back(what);
  }
  return only;
}

}  // namespace

bool is_curve(const Finding& finding) {
  return finding.word == "curve";
}

std::size_t Comparison::changed() const {
  return static_cast<std::size_t>(std::ranges::count_if(changes, [](const Change& c) { return c.bands != 0; }));
}

Comparison compare(const std::vector<Finding>& before, const std::vector<Finding>& after) {
  const auto of_before = with_keys(before), of_after = with_keys(after);
  const ByKey earlier(of_before.begin(), of_before.end()), later(of_after.begin(), of_after.end());
  Comparison comparison;
  for (const auto& [key, finding] : of_before) {
    const auto found = later.find(key);
    if (found == later.end()) continue;
    const bool cost = finding->kind == Finding::Kind::cost;
    (cost ? comparison.costs : comparison.changes).push_back(change_between(*finding, *found->second));
  }
  std::ranges::stable_sort(comparison.changes, std::greater{},
                           [](const Change& c) { return std::pair(c.bands, c.after.kind == Finding::Kind::verdict); });
  std::ranges::stable_sort(comparison.costs, std::greater{},
                           [](const Change& c) { return c.after.number / c.before.number; });
  comparison.only_before = only_in(of_before, later);
  comparison.only_after = only_in(of_after, earlier);
  return comparison;
}

}  // namespace mpmvv::goldens
