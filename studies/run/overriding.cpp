#include "studies/run/overriding.hpp"

#include <fmt/format.h>

#include "studies/error.hpp"

namespace mpmvv {

namespace {

bool varies(const StudyPlan& plan, const std::string& key) {
  return key == plan.sweep || (plan.replicates && key == plan.replicates->key) ||
         (plan.limit && key == plan.limit->key);
}

bool takes(const StudyPlan& plan, SeriesPlan series, const Setting& setting) {
  series.settings.push_back(setting);
  try {
    try_cases(plan, series);
  } catch (const UsageError&) {
    return false;
  }
  return true;
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
    std::size_t taken = 0;
    for (SeriesPlan& series : plan.series) {
      if (where_taken && (is_varied || !takes(plan, series, setting))) continue;
      series.settings.push_back(setting);
      ++taken;
    }
    plan.overridden.push_back(
        fmt::format("{} = {} in {} of {} series", setting.key, setting.value, taken, plan.series.size()));
    plan.text += fmt::format("# Run with {}\n", plan.overridden.back());
  }
}

}  // namespace mpmvv
