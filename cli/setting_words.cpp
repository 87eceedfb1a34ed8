#include "cli/setting_words.hpp"

#include <algorithm>

#include "studies/problems/problem.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::cli {

std::vector<std::string> setting_words(const std::string& key) {
  if (key == "problem") {
    std::vector<std::string> names;
    for (const problems::Problem& problem : problems::problems()) names.push_back(problem.name);
    return names;
  }
  const auto& keys = settings::setting_keys();
  const bool is_setting = std::ranges::find(keys, key, &settings::SettingKey::key) != keys.end();
  return is_setting ? settings::words_of_key(key) : std::vector<std::string>{};
}

}  // namespace mpmvv::cli
