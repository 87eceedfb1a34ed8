#include "cli/case_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "cli/shipped.hpp"
#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"
#include "studies/problems/problem.hpp"
#include "studies/settings/settings.hpp"
#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/shell.hpp"

namespace mpmvv::cli {

using reports::SeriesCommand;

namespace {

constexpr const char* any_value = "{}";  ///< for which a reader puts the value of a point

std::string option_text(const std::string& key, const std::string& value) {
  const std::string word = value == any_value ? value : support::shell_word(value);
  if (key.starts_with("param.")) return fmt::format(" --param {}={}", key.substr(6), word);
  std::string option = key;
  std::ranges::replace(option, '_', '-');
  const auto& keys = settings::setting_keys();
  const auto known = std::ranges::find(keys, key, &settings::SettingKey::key);
  if (known != keys.end() && known->member && known->member->is_flag) return value == "true" ? " --" + option : "";
  return fmt::format(" --{} {}", option, word);
}

/// Whether a search asks for the whole body where a run would take a part of it.
bool probes_whole_bodies(const plan::StudyPlan& plan, const plan::SeriesPlan& replicate) {
  const auto probes = plan::scan_cases(plan, replicate);
  return std::ranges::any_of(probes, [](const cases::Case& c) { return c.measure.whole; });
}

/// A run of the series at a value of this key, for which {} stands. A setting of the key gives way to the value.
std::string run_command(const plan::SeriesPlan& series, const std::string& key) {
  const bool is_varied = plan::varies_with(series, key);
  std::map<std::string, std::string> last;
  for (const settings::Setting& setting : series.settings) last[setting.key] = setting.value;
  if (is_varied) last.erase(key);
  std::string text = "mpmvv run";
  for (const settings::Setting& setting : series.settings)
    if (const auto value = last.extract(setting.key)) text += option_text(setting.key, value.mapped());
  return is_varied ? text + option_text(key, any_value) : text;
}

/// The commands of a series: of its sweep, of the search of its limit, or both.
std::vector<SeriesCommand> commands_of(const plan::StudyPlan& plan, const plan::SeriesPlan& series) {
  const plan::SeriesPlan run = plan::replicates_of(plan, series).front();
  const std::string note =
      plan.replicates ? fmt::format("the first of {} replicates", plan.replicates->values.size()) : "";
  std::vector<SeriesCommand> commands;
  if (!plan.sweep.empty()) commands.push_back({series.name, run_command(run, plan.sweep), note});
  if (!plan.searches(series)) return commands;
  const std::string whole = probes_whole_bodies(plan, run) ? " --whole" : "";
  commands.push_back({.series = series.name,
                      .text = run_command(run, plan.limit->search.key) + whole,
                      .note = "for its limit" + (note.empty() ? "" : ", " + note),
                      .is_probe = true});
  return commands;
}

/// The options that repeat a trial. "shuffle = 3 in 2 of 2 series" was given by --set; what fewer series took, by
/// --set-where-taken.
std::string trial_options(const std::string& trial) {
  std::string options;
  for (const store::TrialSetting& setting : store::settings_of(trial))
    options += fmt::format(" {} {}={}", setting.in_all ? "--set" : "--set-where-taken", setting.key,
                           support::shell_word(setting.value));
  return options;
}

/// The study's file in a folder of studies here, an adapter's among them; its name alone where none holds it.
std::string file_here(const records::StudyResult& study) {
  std::vector<std::filesystem::path> folders{"studies"};
  std::error_code unreadable;
  for (const auto& adapter : std::filesystem::directory_iterator("adapters", unreadable))
    folders.push_back(adapter.path() / "studies");
  std::string name = study.name + ".toml";
  for (const std::filesystem::path& folder : folders)
    if (support::read_file(folder / name) == store::without_trial(study.text)) return folder / name;
  return name;
}

/// What the study's text asks for; nullopt for a check, and for a text that this program would not read any more.
std::optional<plan::StudyPlan> plan_of(const records::StudyResult& study) {
  if (study.kind == records::StudyKind::check) return std::nullopt;
  try {
    return plan::parse_study(store::without_trial(study.text), study.name + ".toml");
  } catch (const support::UsageError&) {
    return std::nullopt;
  }
}

}  // namespace

reports::StudyCall study_call(const records::StudyResult& study) {
  const std::string options = trial_options(store::trial_of(study.text));
  return {is_shipped(study) ? study.name : file_here(study), options};
}

std::vector<SeriesCommand> case_commands(const records::StudyResult& study) {
  std::vector<SeriesCommand> commands;
  if (!store::trial_of(study.text).empty()) return commands;
  if (const auto plan = plan_of(study))
    for (const plan::SeriesPlan& series : plan->series)
      std::ranges::move(commands_of(*plan, series), std::back_inserter(commands));
  return commands;
}

int dimension_of(const records::StudyResult& study) {
  std::set<int> dimensions;
  if (const auto plan = plan_of(study))
    for (const plan::SeriesPlan& series : plan->series)
      dimensions.insert(problems::find_problem(series.setting("problem")->value, series.where).dimension());
  return dimensions.size() == 1 ? *dimensions.begin() : 0;
}

}  // namespace mpmvv::cli
