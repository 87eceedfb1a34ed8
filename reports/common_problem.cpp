#include "reports/common_problem.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::reports {

namespace {

/// The problem of `--set problem=...`; empty where only some series have it, none without such a setting.
std::optional<std::string> problem_of_trial(const records::StudyResult& study) {
  std::optional<std::string> problem;
  for (const store::TrialSetting& setting : store::settings_of(store::trial_of(study.text)))
    if (setting.key == "problem") problem = setting.in_all ? setting.value : "";
  return problem;
}

}  // namespace

std::string common_problem(const records::StudyResult& study, const std::vector<const records::Series*>& series) {
  if (const auto tried = problem_of_trial(study)) return *tried;
  std::string fixed;
  std::map<std::string, std::string> own;
  try {
    const auto file = support::TomlTable::parse(study.text, study.name);
    if (const auto table = file.table("fixed")) fixed = table->text("problem", "");
    for (const auto& table : file.tables("series")) own[table.text("name", "")] = table.text("problem", fixed);
  } catch (const support::UsageError&) {
    return "";
  }
  const auto problem_of = [&](const records::Series* one) {
    const auto found = own.find(one->name);
    return found == own.end() ? fixed : found->second;
  };
  if (series.empty()) return "";
  const std::string first = problem_of(series.front());
  return std::ranges::all_of(series, [&](const auto* one) { return problem_of(one) == first; }) ? first : "";
}

}  // namespace mpmvv::reports
