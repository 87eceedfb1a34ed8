#include "studies/codes/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "studies/codes/case_fields.hpp"
#include "studies/codes/quantity.hpp"
#include "studies/problems/problem.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::codes {

using cases::Case;
using nlohmann::json;
using settings::Setting;
using support::UsageError;

namespace {

/// Returns the settings that no case can do without, among them all parameters of the problem.
std::vector<Setting> necessary_settings(const Case& c, const std::string& where) {
  std::vector<Setting> given{{"problem", c.problem.name, where},
                             {"end_time", fmt::format("{}", c.problem.end_time), where},
                             {"dt", fmt::format("{}", c.resolution.dt), where},
                             {"cells", fmt::format("{}", c.resolution.cells), where},
                             {"ppc", fmt::format("{}", c.resolution.ppc), where}};
  for (const auto& [name, value] : c.problem.parameters)
    given.push_back({"param." + name, fmt::format("{}", value), where});
  return given;
}

/// Whether someone can give the case's value of a key: no value stands where the case has no such choice.
bool can_be_given(const cases::SettingKey& key, const Case& c) {
  if (!key.member || !key.is_of(c.scheme.code) || key.key == "dt" || key.key == "steps") return false;
  if (key.key == "wall_depth") return c.scheme.wall_gradient != cases::WallGradient::none;
  const std::vector<std::string>& words = key.member->words;
  return words.empty() || std::ranges::find(words, cases::text_of(key.member->value(c))) != words.end();
}

/// Returns settings from which `make_case` makes the case: the necessary ones, those whose value is not that of a case
/// of which nothing is said, and those that `make_case` fills in by others.
std::vector<Setting> settings_of(const Case& c) {
  constexpr std::array filled_in{"boundary", "material", "wall_depth"};
  const std::string where = "the case";
  std::vector<Setting> given = necessary_settings(c, where);
  for (const cases::SettingKey& key : cases::setting_keys()) {
    if (!can_be_given(key, c)) continue;
    const cases::Value value = key.member->value(c);
    if (value != key.member->value(Case{}) || std::ranges::find(filled_in, key.key) != filled_in.end())
      given.push_back({key.key, cases::text_of(value), where});
  }
  return given;
}

json columns_json() {
  json columns = json::array();
  for (const Quantity& quantity : all_quantities()) columns.push_back(quantity.word);
  return columns;
}

Case case_of(const json& object, const std::string& where) {
  std::vector<Setting> given;
  for (const auto& [key, value] : object["settings"].items()) given.push_back({key, value.get<std::string>(), where});
  for (const auto& [name, value] : object["parameters"].items())
    given.push_back({"param." + name, value.dump(), where});
  Case c = settings::make_case(given);
  object["dt"].get_to(c.resolution.dt);  // to the last bit
  object["end_time"].get_to(c.problem.end_time);
  return c;
}

}  // namespace

std::string case_text(const Case& c) {
  json chosen = json::object();
  for (const Setting& setting : settings_of(c))
    if (!setting.key.starts_with("param.")) chosen[setting.key] = setting.value;
  const problems::Problem& problem = problems::find_problem(c.problem.name, "the case");
  const json object{{"case", cases::canonical_text(c)},
                    {"problem", c.problem.name},
                    {"parameters", c.problem.parameters},
                    {"settings", chosen},
                    {"dimension", problem.dimension()},
                    {"end_time", c.problem.end_time},
                    {"dt", c.resolution.dt},
                    {"steps", c.resolution.steps},
                    {"h", problem.length(c.problem.parameters) / c.resolution.cells},
                    {"columns", columns_json()},
                    {"units", {{"length", "m"}, {"time", "s"}, {"mass", "kg"}, {"stress", "Pa"}}}};
  return object.dump(2) + "\n";
}

Case read_case(const std::filesystem::path& file) {
  const std::string name = file.string();
  const json object = json::parse(support::require_file(file, "a case, as `mpmvv case` writes it"), nullptr, false);
  if (object.is_discarded()) fail_case(name, "no JSON");
  require_case_fields(object, name);
  Case c = case_of(object, name);
  if (object["case"].get<std::string>() != cases::canonical_text(c))
    fail_case(name, "settings that make another case than its text");
  require_same_fields(object, json::parse(case_text(c)), name);
  return c;
}

}  // namespace mpmvv::codes
