#pragma once
#include <fmt/format.h>

#include <charconv>
#include <map>
#include <span>
#include <string>

#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

/// The values that settings give. What has no meaning is a UsageError with key, value, place and what would be right.
namespace mpmvv::settings {

using Settings = std::map<std::string, Setting>;

/// Settings by their keys, later ones in the place of earlier ones; UsageError on an unknown key.
Settings by_key(std::span<const Setting> given);

const Setting& required(const Settings& settings, const std::string& key);

/// The number given for the key, or `absent` where none is.
double number(const Settings& settings, const std::string& key, double absent);

double positive(const Setting& setting);
double not_negative(const Setting& setting);
bool flag(const Setting& setting);

/// " with KEY = VALUE in WHERE" of the number furthest from 1, of which an overflow is the likeliest; or nothing.
std::string most_extreme(std::span<const Setting> given);

/// A whole number within these bounds.
template <class Integer>
Integer count(const Setting& setting, Integer least, Integer most) {
  Integer value = 0;
  const char* end = setting.value.data() + setting.value.size();
  const auto [stop, error] = std::from_chars(setting.value.data(), end, value);
  if (error != std::errc{} || stop != end || value < least || value > most)
    throw support::UsageError(fmt::format("{} = {} in {} (a whole number from {} to {})", setting.key, setting.value,
                                          setting.where, least, most));
  return value;
}

}  // namespace mpmvv::settings
