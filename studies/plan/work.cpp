#include "studies/plan/work.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "studies/settings/part.hpp"

namespace mpmvv::plan {

using cases::Case;

namespace {

bool is_timed(const Case& c) {
  return c.measure.repeat > 0;
}

void add_limits(const StudyPlan& plan, std::size_t k, Work& work) {
  for (std::size_t s = 0; s < plan.series.size(); ++s) {
    if (!plan.searches(plan.series[s])) continue;
    const std::size_t replicates = replicates_of(plan, plan.series[s]).size();
    for (std::size_t r = 0; r < replicates; ++r) work.limits.push_back({k, s, r});
  }
}

void add_timed(std::vector<Case> cases, Work& work) {
  const std::set<Case> own(cases.begin(), cases.end());
  const auto is_own = [&](const Case& c) { return own.contains(c); };
  std::erase_if(work.timed, [&](const std::vector<Case>& others) {
    const bool share = std::ranges::any_of(others, is_own);
    if (share) std::ranges::remove_copy_if(others, std::back_inserter(cases), is_own);
    return share;
  });
  work.timed.push_back(std::move(cases));
}

}  // namespace

Work work_of(const std::vector<StudyPlan>& plans) {
  Work work;
  for (std::size_t k = 0; k < plans.size(); ++k) {
    std::vector<Case> cases = sweep_cases(plans[k]);
    const auto timed = std::stable_partition(cases.begin(), cases.end(), [](const Case& c) { return !is_timed(c); });
    if (timed != cases.end()) add_timed({timed, cases.end()}, work);
    work.runs.insert(work.runs.end(), cases.begin(), timed);
    if (!plans[k].check.empty()) work.checks.push_back(k);
    if (plans[k].limit) add_limits(plans[k], k, work);
  }
  return work;
}

std::vector<Case> sweep_cases(const StudyPlan& plan, const SeriesPlan& series) {
  std::vector<Case> cases;
  for (const double value : plan.values)
    for (const Case& c : replicates_at(plan, series, value)) cases.push_back(c);
  return cases;
}

std::vector<Case> sweep_cases(const StudyPlan& plan) {
  std::vector<Case> cases;
  for (const SeriesPlan& series : plan.series)
    for (const Case& c : sweep_cases(plan, series)) cases.push_back(c);
  return cases;
}

std::vector<Case> timed_with(const StudyPlan& plan, const Work& work) {
  const std::vector<Case> own = sweep_cases(plan);
  const auto is_of_plan = [&](const Case& c) { return std::ranges::find(own, c) != own.end(); };
  const auto group = std::ranges::find_if(
      work.timed, [&](const std::vector<Case>& cases) { return std::ranges::any_of(cases, is_of_plan); });
  return group == work.timed.end() ? std::vector<Case>{} : *group;
}

std::vector<Case> timed_apart(const std::vector<Case>& cases,
                              const std::function<std::optional<records::Record>(const Case&)>& find) {
  std::set<std::string> sessions;
  std::vector<Case> timed;
  bool lacks_one = false;
  for (const Case& c : cases) {
    if (!is_timed(c)) continue;
    const auto record = find(c);
    lacks_one |= !record;
    if (!record || record->cost.rounds.session.empty()) continue;
    sessions.insert(record->cost.rounds.session);
    timed.push_back(c);
  }
  return lacks_one || sessions.size() > 1 ? timed : std::vector<Case>{};
}

bool is_timed(const StudyPlan& plan) {
  return std::ranges::any_of(sweep_cases(plan), [](const Case& c) { return is_timed(c); });
}

/// A probe runs the whole body: near the limit round-off decides, and it grows differently in a part of the body. Its
/// cost is not asked for.
Case probe_case(const fits::LimitSearch& search, const SeriesPlan& replicate, double value) {
  Case probe = case_at(replicate, search.key, value, replicate.where);
  probe.measure.repeat = 0;
  return settings::as_whole(probe);
}

std::vector<Case> scan_cases(const StudyPlan& plan, const SeriesPlan& replicate) {
  std::vector<Case> cases;
  for (const double value : fits::scan_values(plan.limit->search))
    cases.push_back(probe_case(plan.limit->search, replicate, value));
  return cases;
}

std::vector<Case> scan_cases(const std::vector<StudyPlan>& plans, const LimitTask& limit) {
  const StudyPlan& plan = plans[limit.plan];
  return scan_cases(plan, replicates_of(plan, plan.series[limit.series])[limit.replicate]);
}

}  // namespace mpmvv::plan
