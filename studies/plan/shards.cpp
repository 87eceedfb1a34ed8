#include "studies/plan/shards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "studies/plan/estimates.hpp"
#include "studies/plan/forecast.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::plan {

using cases::Case;

namespace {

/// Work that stays together. Its time is in whole microseconds, so that processors which round differently agree on it.
struct Piece {
  Work work;
  std::int64_t microseconds = 0;
};

/// The key that a case shares with all cases that a search of its limit may probe. With a number of steps their end
/// times differ, and only where a part could stand for the body they ask for the whole.
Case family(Case c) {
  c.problem.end_time = 0;
  c.resolution.dt = 0;
  c.resolution.steps = 0;
  c.scheme.smoothing_length = 0;
  c.measure.whole = false;
  return c;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

void append(Work& to, const Work& more) {
  append(to.runs, more.runs);
  append(to.checks, more.checks);
  append(to.limits, more.limits);
  append(to.timed, more.timed);
}

/// Those that are not in `seen` yet, each once. A run that several ask for is made once.
std::vector<Case> not_in(std::set<Case>& seen, const std::vector<Case>& cases) {
  std::vector<Case> others;
  std::ranges::copy_if(cases, std::back_inserter(others), [&](const Case& c) { return seen.insert(c).second; });
  return others;
}

double seconds_of(const std::vector<Case>& cases, const CostModel& costs) {
  double sum = 0;
  for (const Case& c : cases) sum += costs.time(c).seconds;
  return sum;
}

class Splitter {
 public:
  Splitter(const std::vector<StudyPlan>& plans, const CostModel& costs) : plans_(plans), costs_(costs) {}

  std::vector<Piece> pieces() {
    const Work all = work_of(plans_);
    for (const LimitTask& limit : all.limits) add_limit(limit);
    for (const Case& c : std::set<Case>(all.runs.begin(), all.runs.end())) add_run(c);
    for (const std::size_t check : all.checks)
      add({.runs = {}, .checks = {check}, .limits = {}, .timed = {}}, about_check);
    for (const std::vector<Case>& cases : all.timed)
      add({.runs = {}, .checks = {}, .limits = {}, .timed = {cases}}, seconds_of(not_in(seen_, cases), costs_));
    std::ranges::stable_sort(pieces_, std::greater{}, &Piece::microseconds);
    return pieces_;
  }

 private:
  void add_to(std::size_t piece, const Work& work, double seconds) {
    append(pieces_[piece].work, work);
    pieces_[piece].microseconds += 1 + std::llround(1e6 * seconds);
  }

  std::size_t add(const Work& work, double seconds) {
    pieces_.emplace_back();
    add_to(pieces_.size() - 1, work, seconds);
    return pieces_.size() - 1;
  }

  void add_limit(const LimitTask& limit) {
    const std::vector<Case> scan = scan_cases(plans_, limit);
    const Work work{.runs = {}, .checks = {}, .limits = {limit}, .timed = {}};
    const auto [place, is_new] = families_.try_emplace(family(scan.front()), pieces_.size());
    if (is_new) pieces_.emplace_back();
    add_to(place->second, work, seconds_of(not_in(seen_, scan), costs_));
  }

  void add_run(const Case& c) {
    const Work work{.runs = {c}, .checks = {}, .limits = {}, .timed = {}};
    const double seconds = seconds_of(not_in(seen_, {c}), costs_);
    if (const auto place = families_.find(family(c)); place != families_.end())
      add_to(place->second, work, seconds);
    else
      add(work, seconds);
  }

  const std::vector<StudyPlan>& plans_;
  const CostModel& costs_;
  std::vector<Piece> pieces_;
  std::set<Case> seen_;                   ///< those that some piece so far runs
  std::map<Case, std::size_t> families_;  ///< the piece of each search
};

std::optional<std::size_t> number_from(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

Shard shard_from(const std::string& text) {
  constexpr std::size_t most = 10'000;
  if (const auto slash = text.find('/'); slash != std::string::npos) {
    const auto number = number_from(text.substr(0, slash)), of = number_from(text.substr(slash + 1));
    if (number && of && *number >= 1 && *number <= *of && *of <= most) return {*number, *of};
  }
  throw support::UsageError(
      fmt::format("--shard {} (NUMBER/OF, from 1/OF to OF/OF, at most {}, as in --shard 2/8)", text, most));
}

std::vector<Work> split(const std::vector<StudyPlan>& plans, const CostModel& costs, std::size_t shards) {
  std::vector<Work> works(shards);
  std::vector<std::int64_t> loads(shards, 0);
  for (const Piece& piece : Splitter(plans, costs).pieces()) {
    const auto least = std::ranges::min_element(loads);
    *least += piece.microseconds;
    append(works[static_cast<std::size_t>(least - loads.begin())], piece.work);
  }
  return works;
}

Demand demand(const std::vector<StudyPlan>& plans, const Work& work, const CostModel& costs, int jobs) {
  std::vector<Load> loads(work.checks.size(), {about_check, false});
  std::vector<double> memories;
  std::set<Case> seen;
  const auto added = [&](const std::vector<Case>& cases) {
    std::vector<Case> own = not_in(seen, cases);
    for (const Case& c : own) memories.push_back(memory_estimate(c));
    return own;
  };
  for (const Case& c : added(work.runs)) loads.push_back({costs.time(c).seconds, can_be_shared(c)});
  for (const LimitTask& limit : work.limits) loads.push_back({seconds_of(added(scan_cases(plans, limit)), costs)});
  double alone = 0;
  for (const std::vector<Case>& cases : work.timed)
    for (const Case& c : added(cases)) {
      const double seconds = costs.time(c).seconds;
      alone += share_alone(c) * seconds;
      loads.push_back({(1 - share_alone(c)) * seconds, false});
    }
  const auto at_once = std::min(static_cast<std::ptrdiff_t>(jobs), std::ssize(memories));
  std::ranges::partial_sort(memories, memories.begin() + at_once, std::greater{});
  return {seconds_on(jobs, std::move(loads)) + alone,
          std::accumulate(memories.begin(), memories.begin() + at_once, 0.0)};
}

}  // namespace mpmvv::plan
