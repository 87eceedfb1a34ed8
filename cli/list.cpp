#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "cli/code_list.hpp"
#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/help.hpp"
#include "cli/lines.hpp"
#include "cli/markdown.hpp"
#include "cli/problem_list.hpp"
#include "cli/study_list.hpp"
#include "cli/table.hpp"
#include "studies/checks/check.hpp"
#include "studies/codes/expressions.hpp"
#include "studies/plan/file_reference.hpp"
#include "studies/plan/file_tables.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

namespace {

/// `velocity-updates` of `velocity_update`.
std::string plural(std::string key) {
  std::ranges::replace(key, '_', '-');
  if (key == "basis") return "bases";
  if (key == "boundary") return "boundaries";
  return key + (key.ends_with('s') ? "es" : "s");
}

/// The lists and the setting whose words they show.
std::vector<std::pair<std::string, std::string>> word_lists() {
  std::vector<std::pair<std::string, std::string>> lists;
  for (const settings::SettingKey& key : settings::setting_keys())
    if (!settings::words_of_key(key.key).empty()) lists.emplace_back(plural(key.key), key.key);
  return lists;
}

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const checks::Check& check : checks::checks()) names.push_back(check.name);
  return names;
}

/// The keys of each table of a study file.
nlohmann::json study_file_json() {
  nlohmann::json tables = nlohmann::json::array();
  for (const plan::FileTable& table : plan::file_tables()) {
    nlohmann::json keys = nlohmann::json::array();
    for (const plan::FileKey& key : table.keys)
      keys.push_back({{"key", key.key}, {"takes", key.takes}, {"default", key.absent}, {"meaning", key.meaning}});
    tables.push_back({{"table", table.name}, {"takes_settings", table.takes_settings}, {"keys", keys}});
  }
  return tables;
}

/// Ways to write formulas.
nlohmann::json dialects_json() {
  nlohmann::json dialects = nlohmann::json::array();
  for (const codes::Dialect& dialect : mms::expression::dialects())
    dialects.push_back({{"dialect", dialect.name}, {"of", dialect.what}});
  return dialects;
}

void print_dialects(const nlohmann::json& dialects) {
  Table table({{"dialect"}, {"of what", Table::Kind::prose}}, 0);
  for (const nlohmann::json& dialect : dialects) table.add({dialect["dialect"], dialect["of"]});
  table.print();
}

void print_studies(const nlohmann::json& studies) {
  Table table({{"study"}, {"title (claims)", Table::Kind::prose}}, 0);
  for (const nlohmann::json& study : studies) {
    const auto claims = study["claims"].get<std::vector<std::string>>();
    const std::string title = study["title"];
    table.add({study["name"], claims.empty() ? title : fmt::format("{} ({})", title, fmt::join(claims, ", "))});
  }
  table.print();
}

int list(const std::string& what, const std::string& folder, bool json) {
  nlohmann::json all = nlohmann::json::object();
  if (what == "studies") {
    all["studies"] = study_list(folder);
    if (!json) print_studies(all["studies"]);
  } else if (!folder.empty()) {
    throw support::UsageError("--studies without studies (mpmvv list studies --studies FOLDER)");
  }
  if (what.empty() || what == "problems") {
    all["problems"] = problem_list();
    if (!json) print_problems();
  }
  Table table({{"key"}, {"words", Table::Kind::prose}}, 0);
  const auto add_words = [&](const std::string& name, const std::vector<std::string>& words) {
    all[name] = words;
    table.add({name, fmt::format("{}", fmt::join(words, ", "))});
  };
  for (const auto& [name, key] : word_lists()) {
    if (what.empty() || what == name) add_words(name, settings::words_of_key(key));
  }
  if (what.empty() || what == "checks") add_words("checks", check_names());
  if (what == "codes") {
    all[what] = codes_json();
    if (!json) print_codes(all[what]);
  }
  if (what == "dialects") {
    all[what] = dialects_json();
    if (!json) print_dialects(all[what]);
  }
  if (what == "study-file") {
    all[what] = study_file_json();
    if (!json) print_markdown(plan::study_file_reference());
  }
  if (all.empty())
    throw support::UsageError(fmt::format("unknown list '{}' (known: {})", what, fmt::join(list_names(), ", ")));
  if (json)
    print_json(all);
  else if (!what.empty())
    table.print();
  else {
    table.print_apart();
    print_indented("further lists: mpmvv list studies, codes, dialects or study-file", 0);
  }
  return 0;
}

}  // namespace

std::vector<std::string> list_names() {
  std::vector<std::string> names{"studies", "problems", "codes", "dialects", "checks", "study-file"};
  for (const auto& [name, key] : word_lists()) names.push_back(name);
  return names;
}

void add_list(CLI::App& app, int& exit_code) {
  auto what = std::make_shared<std::string>(), folder = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand(
      "list",
      "Print the problems with their values and the words of every key, or one list, of the studies for instance");
  command
      ->add_option("what", *what,
                   "studies, study-file, codes, dialects, problems, bases, ... (default: all but the first four)")
      ->type_name("LIST");
  command->add_option("--studies", *folder, "folder of study files (default: the one that comes with the program)")
      ->type_name("FOLDER");
  command->add_flag("--json", *json, "print one JSON object");
  add_examples(*command, {"mpmvv list studies", "mpmvv list problems", "mpmvv list codes", "mpmvv list dialects",
                          "mpmvv list bases", "mpmvv list study-file", "mpmvv list --json"});
  command->callback([what, folder, json, &exit_code] { exit_code = list(*what, *folder, *json); });
}

}  // namespace mpmvv::cli
