#pragma once
#include <map>
#include <span>
#include <string>

#include "studies/settings/settings.hpp"

namespace mpmvv::settings {

using Settings = std::map<std::string, Setting>;

/// Returns the settings by their keys; later ones replace earlier ones. Throws UsageError on an unknown key.
Settings by_key(std::span<const Setting> given);

/// Returns the setting with this key. Throws UsageError where it is not given.
const Setting& required(const Settings& settings, const std::string& key);

/// Returns " with KEY = VALUE in WHERE" for the number whose magnitude is furthest from 1, the likeliest cause of an
/// overflow; empty where no number is given.
std::string most_extreme(std::span<const Setting> given);

}  // namespace mpmvv::settings
