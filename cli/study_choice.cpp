#include "cli/study_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/console.hpp"
#include "cli/outputs.hpp"
#include "cli/shipped.hpp"
#include "studies/plan/claim_reader.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using plan::Overriding;

namespace {

settings::Setting setting_from(const std::string& text, const char* option) {
  const auto equals = text.find('=');
  if (equals == 0 || equals == std::string::npos)
    throw support::UsageError(fmt::format("{} {} (key=value, as in {} shuffle=1)", option, text, option));
  return {text.substr(0, equals), text.substr(equals + 1), option};
}

std::vector<Overriding> overriding_settings(const StudyChoice& choice) {
  std::vector<Overriding> all;
  const auto add = [&all](const std::string& text, const char* option, bool where_taken) {
    const settings::Setting setting = setting_from(text, option);
    for (const Overriding& other : all)
      if (other.setting.key == setting.key)
        throw support::UsageError(fmt::format("{} = {} in {} beside {} = {} in {} (one value)", setting.key,
                                              setting.value, option, setting.key, other.setting.value,
                                              other.setting.where));
    all.push_back({setting, where_taken});
  };
  for (const std::string& text : choice.settings) add(text, "--set", false);
  for (const std::string& text : choice.where_taken) add(text, "--set-where-taken", true);
  return all;
}

/// A setting that no study takes is a mistake of the user: UsageError with the refusal.
void require_taken(const std::vector<Overriding>& settings, const std::vector<plan::StudyPlan>& plans) {
  for (std::size_t k = 0; k < settings.size(); ++k) {
    std::string refusal;
    bool taken = false;
    for (const plan::StudyPlan& plan : plans) {
      taken = taken || plan.overridden[k].series > 0;
      if (!plan.overridden[k].refusal.empty()) refusal = plan.overridden[k].refusal;
    }
    if (!taken && !refusal.empty())
      throw support::UsageError(
          fmt::format("no series takes {} = {} ({})", settings[k].setting.key, settings[k].setting.value, refusal));
  }
}

/// The folders in which claims may be stated that the studies name: beside them, and among the studies that come with
/// the program.
std::vector<std::filesystem::path> claim_folders(const std::vector<std::string>& files) {
  std::vector<std::filesystem::path> folders;
  for (const std::string& file : files)
    if (const auto folder = std::filesystem::path(file).parent_path();
        std::ranges::find(folders, folder) == folders.end())
      folders.push_back(folder);
  if (const auto own = shipped("studies"); !own.empty()) folders.push_back(own);
  return folders;
}

bool is_left_out(plan::StudyPlan& plan, const std::string& file, plan::CodeFinder& codes, AbsentCode allowed) {
  const std::string absent = plan::complete_series(plan, file, codes);
  if (absent.empty()) return false;
  if (allowed == AbsentCode::refused) throw support::UsageError(fmt::format("{}: {}", file, absent));
  note("{} is left out: {}\n", plan.name, absent);
  return true;
}

}  // namespace

void add_study_choice(CLI::App& command, StudyChoice& choice) {
  command
      .add_option("files", choice.names,
                  "study files (TOML), or names of studies in --studies (default: all of --studies)")
      ->type_name("FILE");
  command
      .add_option("--studies", choice.studies,
                  "folder of study files (default: for names, the one that comes with the program)")
      ->type_name("FOLDER");
}

ChosenStudies read_plans(const StudyChoice& choice, const std::string& db, plan::CodeFinder& codes, AbsentCode absent) {
  const std::vector<Overriding> overriding = overriding_settings(choice);
  const std::vector<std::string> files = named_study_files(choice.names, choice.studies);
  std::vector<plan::StudyPlan> plans;
  for (const std::string& file : files) {
    plans.push_back(plan::read_study(file, overriding));
    for (std::size_t k = 0; k + 1 < plans.size(); ++k)
      if (plans[k].name == plans.back().name)
        throw support::UsageError(fmt::format("two study files named '{}' (stems must differ)", plans.back().name));
    if (is_left_out(plans.back(), file, codes, absent)) plans.pop_back();
  }
  require_taken(overriding, plans);
  for (const plan::StudyPlan& plan : plans)
    for (const plan::Overridden& done : plan.overridden) note("{}: {}\n", plan.name, done.what);
  plan::state_claims(plans, claim_folders(files));
  // A folder cannot be a store; opening it says so.
  if (!std::filesystem::is_directory(db)) require_apart("--db", db, {files.begin(), files.end()});
  const std::size_t left_out = files.size() - plans.size();
  return {std::move(plans), left_out};
}

}  // namespace mpmvv::cli
