#include "studies/plan/plan_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/claims/samples.hpp"
#include "studies/records/record.hpp"
#include "studies/support/error.hpp"
#include "studies/support/words.hpp"

namespace mpmvv::plan {

using settings::Setting;
using support::UsageError;

namespace {

/// A check makes its series when it runs.
void require_series(const std::vector<std::string>& names, const StudyPlan& plan, const std::string& where) {
  if (!plan.check.empty()) return;
  std::vector<std::string> known;
  for (const SeriesPlan& series : plan.series) known.push_back(series.name);
  for (const std::string& name : names) require_word("series", name, known, where);
}

double nearest(const std::vector<double>& values, double to) {
  return *std::ranges::min_element(values, {}, [to](double value) { return std::abs(value - to); });
}

bool every_series_has(const StudyPlan& plan, const std::string& key) {
  return std::ranges::all_of(plan.series, [&](const SeriesPlan& series) { return series.setting(key) != nullptr; });
}

struct VariedKey {
  std::string key, what, where;
};

/// The keys that the sweep, the search of a limit and the replicates set.
std::vector<VariedKey> varied_keys(const StudyPlan& plan) {
  std::vector<VariedKey> varied;
  if (!plan.sweep.empty()) varied.push_back({plan.sweep, "the sweep over it", plan.sweep_where});
  if (plan.limit) varied.push_back({plan.limit->search.key, "the search of its limit", plan.limit->where});
  if (plan.replicates) varied.push_back({plan.replicates->key, "its replicates", plan.replicates->where});
  return varied;
}

/// Whether a setting takes effect in some run. For one from [fixed] that run may be of another series.
bool counts(const StudyPlan& plan, const Setting& setting) {
  if (plan.replicates && setting.key == plan.replicates->key) return false;
  if (!plan.sweep.empty() && setting.key != plan.sweep) return true;
  return plan.limit && setting.key != plan.limit->search.key &&
         std::ranges::any_of(plan.series, [&](const SeriesPlan& series) {
           const Setting* own = series.setting(setting.key);
           return own && own->where == setting.where && plan.searches(series);
         });
}

/// The setting that a norm needs; empty for those at the end of a run, which are always measured.
std::string setting_of(const std::string& norm) {
  const auto found = std::ranges::find_if(records::run_errors(), [&](const auto& n) { return n.name == norm; });
  return found == records::run_errors().end() ? "" : found->setting;
}

/// Throws unless each of the named series, or of all when none is named, turns the setting on.
void require_setting(const StudyPlan& plan, const std::string& setting, const std::vector<std::string>& names,
                     const std::string& what) {
  if (setting.empty()) return;
  for (const SeriesPlan& series : plan.series) {
    if (!names.empty() && std::ranges::find(names, series.name) == names.end()) continue;
    if (const Setting* asked = series.setting(setting); !asked || asked->value != "true")
      throw UsageError(fmt::format("{} without {} = true in series '{}'", what, setting, series.name));
  }
}

/// The named series; when none is named, those that do not turn the setting off.
std::vector<std::string> series_with(const StudyPlan& plan, const std::string& setting,
                                     std::vector<std::string> names) {
  if (!names.empty() || setting.empty()) return names;
  for (const SeriesPlan& series : plan.series)
    if (const Setting* asked = series.setting(setting); !asked || asked->value != "false") names.push_back(series.name);
  return names;
}

}  // namespace

void require_word(const std::string& what, const std::string& word, const std::vector<std::string>& known,
                  const std::string& where) {
  if (std::find(known.begin(), known.end(), word) == known.end())
    throw UsageError(fmt::format("unknown {} '{}' in {} (known: {})", what, word, where, support::listed(known)));
}

std::string norm_of(const support::TomlTable& table, const char* key) {
  std::string norm = table.text(key);
  std::vector<std::string> known = records::norm_words();
  known.insert(known.end(), {"ns_per_particle_step", "y"});
  require_word(key, norm, known, table.where(key));
  return norm;
}

std::string series_name(const support::TomlTable& table, const char* key, const StudyPlan& plan) {
  std::string name = table.text(key);
  require_series({name}, plan, table.where(key));
  return name;
}

std::vector<std::string> series_names(const support::TomlTable& table, const char* key, const StudyPlan& plan) {
  std::vector<std::string> names = table.texts(key);
  require_series(names, plan, table.where(key));
  for (auto name = names.begin(); name != names.end(); ++name)
    if (std::find(names.begin(), name, *name) != name)
      throw UsageError(fmt::format("series '{}' twice in {} (once)", *name, table.where(key)));
  return names;
}

fits::Window read_window(const support::TomlTable& table, const char* key) {
  const auto ends = table.numbers(key);
  if (ends.size() != 2 || !(ends[0] <= ends[1]))
    throw UsageError(fmt::format("{} in {} (two swept values, the smaller first)", key, table.where(key)));
  return {ends[0], ends[1]};
}

void require_points(const StudyPlan& plan, const fits::Window& window, int least, const std::string& where) {
  if (!plan.check.empty()) return;
  if (plan.values.empty()) throw UsageError(fmt::format("window in {} of a study without a [sweep] (one)", where));
  for (const double end : {window.from, window.to})
    if (std::ranges::none_of(plan.values, [&](double x) { return fits::Window{end, end}.holds(x); }))
      throw UsageError(fmt::format("window [{}, {}] in {} ends at {}, which is no swept value ({} is the nearest)",
                                   window.from, window.to, where, end, nearest(plan.values, end)));
  const auto count = std::ranges::count_if(plan.values, [&](double x) { return window.holds(x); });
  if (count < least)
    throw UsageError(fmt::format("window [{}, {}] in {} holds {} swept values (at least {})", window.from, window.to,
                                 where, count, least));
}

void require_step_size(const StudyPlan& plan, const std::string& where) {
  if (plan.check.empty() && !claims::has_step_size(plan.sweep))
    throw UsageError(fmt::format("a fit in {} over '{}', which is no step size (a sweep over cells, ppc, cfl or dt)",
                                 where, plan.sweep));
}

void require_no_idle_settings(const StudyPlan& plan, const SeriesPlan& series) {
  if (plan.sweep.empty() && plan.limit && !plan.searches(series))
    throw UsageError(fmt::format("series '{}' in {} is neither swept nor searched (its name in `series` of {})",
                                 series.name, series.where, plan.limit->where));
  for (const auto& [key, what, where] : varied_keys(plan))
    if (const Setting* setting = series.setting(key); setting && !counts(plan, *setting))
      throw UsageError(fmt::format("{} in {} beside {} in {} (one of them)", key, setting->where, what, where));
  if (!plan.sweep.empty() && plan.searches(series) && plan.sweep != plan.limit->search.key &&
      varies_with(series, plan.sweep) && !series.setting(plan.sweep))
    throw UsageError(
        fmt::format("the limit in {} has no {} for series '{}' (one `{}` in [fixed] or in the series; those of "
                    "[sweep] are for its errors)",
                    plan.limit->where, plan.sweep, series.name, plan.sweep));
}

void require_different_runs(std::vector<cases::Case> cases, const std::string& what, const std::string& where) {
  for (cases::Case& c : cases) c.measure = {};
  std::ranges::sort(cases);
  if (std::ranges::adjacent_find(cases) != cases.end())
    throw UsageError(
        fmt::format("two {} are the same run in {} (values of which each makes another one)", what, where));
}

void require_cost(const StudyPlan& plan, const std::string& where) {
  if (!plan.check.empty() || plan.sweep.empty() || !every_series_has(plan, "repeat"))
    throw UsageError(
        fmt::format("cost in {} without a sweep and `repeat` in every series (it says how often a case runs "
                    "for its cost)",
                    where));
}

void require_measured(const StudyPlan& plan, const std::string& norm, const std::vector<std::string>& names,
                      const std::string& where) {
  if ((norm == "y") == plan.check.empty())
    throw UsageError(fmt::format("norm '{}' in {} (y for the curves of a check, an error norm for runs)", norm, where));
  if (norm == "ns_per_particle_step") require_cost(plan, where);
  require_setting(plan, setting_of(norm), names, fmt::format("norm '{}' in {}", norm, where));
}

std::vector<std::string> measured_series(const StudyPlan& plan, const std::string& norm, std::vector<std::string> names,
                                         const std::string& where) {
  names = series_with(plan, setting_of(norm), std::move(names));
  require_measured(plan, norm, names, where);
  return names;
}

std::vector<std::string> series_with_particles(const StudyPlan& plan, std::vector<std::string> names,
                                               const std::string& where) {
  constexpr const char* setting = "particle_errors";
  if (plan.replicates)
    throw UsageError(fmt::format("particles in {} beside replicates in {} (one run's particles are drawn)", where,
                                 plan.replicates->where));
  names = series_with(plan, setting, std::move(names));
  require_setting(plan, setting, names, fmt::format("particles in {}", where));
  return names;
}

}  // namespace mpmvv::plan
