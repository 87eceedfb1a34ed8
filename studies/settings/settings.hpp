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

/// Returns the words that a key takes; empty for numbers.
std::vector<std::string> words_of_key(const std::string& key);

/// Throws UsageError, with the known keys, on an unknown key.
void require_known_key(const std::string& key, const std::string& where);

/// Returns the problem that these settings choose, with its parameters, end time and `quarter`. The values of other
/// keys are not checked. Throws as make_case does.
cases::ProblemChoice make_choice(std::span<const Setting> settings);

/// Returns the case that these settings describe; later settings replace earlier ones. Every value is checked here,
/// alone and in combination. Throws UsageError that says what is wrong, where, and what would be right.
cases::Case make_case(std::span<const Setting> settings);

}  // namespace mpmvv::settings
