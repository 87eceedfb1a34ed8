#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "solver/boundary/boundaries.hpp"
#include "solver/words.hpp"
#include "studies/settings/settings.hpp"
#include "studies/settings/solver_words.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings {

std::vector<std::string> words_of_key(const std::string& key) {
  if (key == "boundary") return strings(solver::words<solver::AnyBoundary>());
  for (const SolverWords& list : solver_words())
    if (list.key == key) return list.words;
  const auto found = std::ranges::find(setting_keys(), key, &SettingKey::key);
  return found != setting_keys().end() && found->member ? found->member->words : std::vector<std::string>();
}

void require_known_key(const std::string& key, const std::string& where) {
  if (key.starts_with("param.")) return;
  std::vector<std::string> known;
  for (const SettingKey& k : setting_keys()) {
    if (k.key == key) return;
    known.push_back(k.key);
  }
  throw support::UsageError(
      fmt::format("unknown key '{}' in {} (known: {}, param)", key, where, fmt::join(known, ", ")));
}

}  // namespace mpmvv::settings
