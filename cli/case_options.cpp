#include "cli/case_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/command.hpp"
#include "cli/setting_words.hpp"
#include "cli/shipped.hpp"
#include "studies/plan/external_series.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

using support::UsageError;

namespace {

/// What counts where a key is not given; empty where the case then has nothing of the kind.
std::string default_of(const settings::SettingKey& key) {
  if (key.absent) return key.absent->help;
  const std::string value = cases::text_of(key.member->value(cases::Case{}));
  return value.empty() || value == "0" || value == "none" || value == "false" ? "" : fmt::format("default: {}", value);
}

std::string help_of(const settings::SettingKey& key, const std::string& where_required) {
  std::string help = key.meaning;
  if (const auto words = setting_words(key.key); !words.empty()) help += fmt::format(": {}", fmt::join(words, ", "));
  std::string absent = default_of(key);
  if (key.key != "problem" && absent.ends_with("required")) absent += where_required;
  return absent.empty() ? help : fmt::format("{} ({})", help, absent);
}

bool takes_word(const settings::SettingKey& key) {
  return !setting_words(key.key).empty() ||
         (key.member && std::holds_alternative<std::string>(key.member->value(cases::Case{})));
}

}  // namespace

settings::Setting parameter_setting(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError(fmt::format("--param {} (name=value, as in --param amplitude=0.02)", text));
  return {"param." + text.substr(0, equals), text.substr(equals + 1), "--param"};
}

void CaseOptions::add_to(CLI::App& command, const std::string& where_required) {
  for (const settings::SettingKey& key : settings::setting_keys()) {
    std::string name = "--" + key.key;
    std::replace(name.begin(), name.end(), '_', '-');
    const std::string help = help_of(key, where_required);
    if (key.member && key.member->is_flag)
      flags_[key.key] = command.add_flag(name, help);
    else
      given_[key.key] = command.add_option(name, help)->expected(1)->type_name(takes_word(key) ? "WORD" : "NUMBER");
  }
  command.add_option("--param", parameters_, "physical value of the problem (repeatable)")->type_name("NAME=VALUE");
}

std::vector<settings::Setting> CaseOptions::settings() const {
  std::vector<settings::Setting> all;
  for (const auto& [key, option] : given_)
    if (option->count() > 0) all.push_back({key, option->as<std::string>(), option->get_name()});
  for (const std::string& parameter : parameters_) {
    all.push_back(parameter_setting(parameter));
    const auto same = [&](const settings::Setting& earlier) { return earlier.key == all.back().key; };
    if (std::any_of(all.begin(), all.end() - 1, same))
      throw UsageError(fmt::format("--param {} after another value for it (each parameter once)", parameter));
  }
  for (const auto& [key, option] : flags_)
    if (option->count() > 0) all.push_back({key, option->as<std::string>(), option->get_name()});
  return all;
}

cases::Case CaseOptions::the_case() const {
  std::vector<settings::Setting> all = settings();
  plan::CodeFinder(shipped("adapters")).complete_variant(all, ".");
  return settings::make_case(all);
}

cases::ProblemChoice CaseOptions::the_choice() const {
  return settings::make_choice(settings());
}

}  // namespace mpmvv::cli
