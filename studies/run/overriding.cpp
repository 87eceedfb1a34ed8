#include "studies/run/overriding.hpp"

#include <fmt/format.h>

#include "studies/error.hpp"
#include "studies/trial.hpp"

namespace mpmvv {

namespace {

bool varies(const StudyPlan& plan, const std::string& key) {
  return key == plan.sweep || (plan.replicates && key == plan.replicates->key) ||
         (plan.limit && key == plan.limit->key);
}

/// Why a series does not take a setting; empty when it does.
std::string refusal(const StudyPlan& plan, SeriesPlan series, const Setting& setting) {
  series.settings.push_back(setting);
  try {
    try_cases(plan, series);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

void try_cases(const StudyPlan& plan, const SeriesPlan& series) {
  for (const double value : plan.values) replicates_at(plan, series, value);
  if (plan.limit)
    for (const SeriesPlan& one : replicates_of(plan, series))
      case_at(one, plan.limit->key, plan.limit->to, plan.limit_where);
}

void override_series(const std::vector<Overriding>& settings, StudyPlan& plan) {
  for (const auto& [setting, where_taken] : settings) {
    require_known_key(setting.key, setting.where);
    const bool is_varied = varies(plan, setting.key);
    if (is_varied && !where_taken)
      throw UsageError(fmt::format("{} in {} for study '{}', which varies it itself (another key)", setting.key,
                                   setting.where, plan.name));
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
    if (done.series > 0) plan.text = with_trial(plan.text, done.what);
    plan.overridden.push_back(done);
  }
}

}  // namespace mpmvv
