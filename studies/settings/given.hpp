#pragma once
#include <map>
#include <span>
#include <string>

#include "studies/settings/settings.hpp"

namespace mpmvv::settings {

using Settings = std::map<std::string, Setting>;

/// Settings by their keys, later ones in the place of earlier ones; UsageError on an unknown key.
Settings by_key(std::span<const Setting> given);

/// UsageError where the key is not given.
const Setting& required(const Settings& settings, const std::string& key);

/// " with KEY = VALUE in WHERE" of the number furthest from 1, of which an overflow is the likeliest; or nothing.
std::string most_extreme(std::span<const Setting> given);

}  // namespace mpmvv::settings
