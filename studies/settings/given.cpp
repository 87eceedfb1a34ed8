#include "studies/settings/given.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "studies/support/error.hpp"

namespace mpmvv::settings {

using support::UsageError;

const Setting& required(const Settings& settings, const std::string& key) {
  const auto it = settings.find(key);
  if (it == settings.end()) throw UsageError(fmt::format("no {0} given (--{0}, or {0} in a study file)", key));
  return it->second;
}

Settings by_key(std::span<const Setting> given) {
  Settings settings;
  for (const Setting& setting : given) {
    require_known_key(setting.key, setting.where);
    settings[setting.key] = setting;
  }
  return settings;
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
