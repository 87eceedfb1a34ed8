#include "studies/plan/overriding.hpp"

#include <fmt/format.h>

#include "studies/plan/plan_rules.hpp"
#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::plan {

namespace {

bool varies(const StudyPlan& plan, const std::string& key) {
  return key == plan.sweep || (plan.replicates && key == plan.replicates->key) ||
         (plan.limit && key == plan.limit->search.key);
}

/// Why a series does not take a setting; empty when it does.
std::string refusal(const StudyPlan& plan, SeriesPlan series, const settings::Setting& setting) {
  series.settings.push_back(setting);
  try {
    try_cases(plan, series);
  } catch (const support::UsageError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

void try_cases(const StudyPlan& plan, const SeriesPlan& series) {
  const auto require_different_replicates = [&](const std::vector<cases::Case>& cases) {
    if (plan.replicates)
      require_different_runs(cases, fmt::format("replicates of series '{}'", series.name), plan.replicates->where);
  };
  std::vector<cases::Case> swept, at_end_of_search;
  for (const double value : plan.values) {
    const std::vector<cases::Case> replicates = replicates_at(plan, series, value);
    require_different_replicates(replicates);
    swept.push_back(replicates.front());
  }
  if (varies_with(series, plan.sweep))
    require_different_runs(swept, fmt::format("swept values of series '{}'", series.name), plan.sweep_where);
  if (!plan.searches(series)) return;
  const auto& [search, names, where] = *plan.limit;
  for (const SeriesPlan& one : replicates_of(plan, series))
    at_end_of_search.push_back(case_at(one, search.key, search.to, where));
  require_different_replicates(at_end_of_search);
}

void override_series(const std::vector<Overriding>& settings, StudyPlan& plan) {
  for (const auto& [setting, where_taken] : settings) {
    settings::require_known_key(setting.key, setting.where);
    if (!plan.check.empty()) {
      plan.overridden.push_back({.what = fmt::format("{} = {} changes nothing in a check", setting.key, setting.value),
                                 .refusal = fmt::format("a check has no settings for {}", setting.where)});
      continue;
    }
    const bool is_varied = varies(plan, setting.key);
    if (is_varied && !where_taken)
      throw support::UsageError(fmt::format("{} in {} for study '{}', which varies it itself (another key)",
                                            setting.key, setting.where, plan.name));
    Overridden done;
    for (SeriesPlan& series : plan.series) {
      if (where_taken && is_varied) continue;
      const std::string why_not = where_taken ? refusal(plan, series, setting) : "";
      if (!why_not.empty()) {
        done.refusal = why_not;
        continue;
      }
      series.settings.push_back(setting);
      ++done.series;
    }
    done.what = fmt::format("{} = {} in {} of {} series", setting.key, setting.value, done.series, plan.series.size());
    if (done.series > 0) plan.text = store::with_trial(plan.text, done.what);
    plan.overridden.push_back(done);
  }
}

}  // namespace mpmvv::plan
