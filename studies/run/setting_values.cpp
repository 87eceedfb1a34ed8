#include "studies/run/setting_values.hpp"

#include <cmath>

namespace mpmvv {

double number(const Settings& settings, const std::string& key, double absent) {
  const auto it = settings.find(key);
  return it == settings.end() ? absent : parse_number(it->second);
}

double positive(const Setting& setting) {
  const double value = parse_number(setting);
  if (!(value > 0))
    throw UsageError(fmt::format("{} = {} in {} (a number > 0)", setting.key, setting.value, setting.where));
  return value;
}

double not_negative(const Setting& setting) {
  const double value = parse_number(setting);
  if (value < 0)
    throw UsageError(fmt::format("{} = {} in {} (a number >= 0)", setting.key, setting.value, setting.where));
  return value;
}

const Setting& required(const Settings& settings, const std::string& key) {
  const auto it = settings.find(key);
  if (it == settings.end()) throw UsageError(fmt::format("no {} given (it is required)", key));
  return it->second;
}

bool flag(const Setting& setting) {
  if (setting.value == "true" || setting.value == "false") return setting.value == "true";
  throw UsageError(fmt::format("{} = {} in {} (true or false)", setting.key, setting.value, setting.where));
}

Settings by_key(std::span<const Setting> given) {
  Settings settings;
  for (const Setting& setting : given) {
    require_known_key(setting.key, setting.where);
    settings[setting.key] = setting;
  }
  return settings;
}

double parse_number(const Setting& setting) {
  double value = 0;
  const char* end = setting.value.data() + setting.value.size();
  const auto [stop, error] = std::from_chars(setting.value.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value))
    throw UsageError(fmt::format("{} = '{}' in {} (a finite number)", setting.key, setting.value, setting.where));
  return value;
}

}  // namespace mpmvv
