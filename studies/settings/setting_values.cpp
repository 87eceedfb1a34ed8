#include "studies/settings/setting_values.hpp"

#include <cmath>

#include "studies/settings/scales.hpp"

namespace mpmvv::settings {

using support::UsageError;

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
  if (value != 0 && !has_size(value))
    throw UsageError(fmt::format("{} = {} in {} (0, or a number from {} to {} in size)", setting.key, setting.value,
                                 setting.where, least_size, largest_size));
  return value;
}

std::string most_extreme(std::span<const Setting> given) {
  const Setting* most = nullptr;
  double distance = 0;
  for (const Setting& setting : given) {
    double value = 0;
    std::from_chars(setting.value.data(), setting.value.data() + setting.value.size(), value);
    if (value == 0 || std::abs(std::log10(std::abs(value))) < distance) continue;
    distance = std::abs(std::log10(std::abs(value)));
    most = &setting;
  }
  return most ? fmt::format(" with {} = {} in {}", most->key, most->value, most->where) : "";
}

}  // namespace mpmvv::settings
