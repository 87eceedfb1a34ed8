#pragma once
#include <span>
#include <string>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/cases/setting_keys.hpp"

namespace mpmvv::settings {

using cases::parse_number;
using cases::Setting;
using cases::setting_keys;
using cases::SettingKey;

/// The words that a key takes, empty for numbers.
std::vector<std::string> words_of_key(const std::string& key);

/// Throws UsageError on an unknown key, with the known ones.
void require_known_key(const std::string& key, const std::string& where);

/// The problem that these settings choose, and its values; other keys are not looked at. Throws as make_case does.
cases::ProblemChoice make_choice(std::span<const Setting> settings);

/// The case that these settings describe, later ones overwriting earlier ones. Every value is checked here, alone
/// and in combination; a UsageError says what is wrong, where, and what would be right.
cases::Case make_case(std::span<const Setting> settings);

}  // namespace mpmvv::settings
