#pragma once
#include <span>
#include <string>
#include <vector>

#include "studies/cases/case.hpp"

namespace mpmvv::settings {

/// One choice as a user wrote it, on the command line or in a study file.
struct Setting {
  std::string key;    ///< `cells`, `basis`, `param.amplitude`; a study file's spelling, `_` for `-`
  std::string value;  ///< as text
  std::string where;  ///< "--cells" or "studies/bar.toml:7", for messages
};

/// A key that settings may have, for help and for the check of study files.
struct SettingKey {
  std::string key;
  std::string meaning;
  bool is_flag = false;  ///< true or false
};
const std::vector<SettingKey>& setting_keys();

/// The words that a key takes, empty for numbers.
std::vector<std::string> words_of_key(const std::string& key);

/// Throws UsageError on an unknown key, with the known ones.
void require_known_key(const std::string& key, const std::string& where);

/// The problem that these settings choose, and its values; other keys are not looked at. Throws as make_case does.
cases::ProblemChoice make_choice(std::span<const Setting> settings);

/// The case that these settings describe, later ones overwriting earlier ones. Every value is checked here, alone
/// and in combination; a UsageError says what is wrong, where, and what would be right.
cases::Case make_case(std::span<const Setting> settings);

/// A number, wholly and finite; UsageError otherwise.
double parse_number(const Setting& setting);

}  // namespace mpmvv::settings
