#include "studies/support/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "studies/support/error.hpp"

namespace mpmvv::support {

std::string listed(const std::vector<std::string>& names) {
  std::vector<std::string> items;
  for (const std::string& name : names)
    items.push_back(name.find(',') == std::string::npos ? name : fmt::format("'{}'", name));
  return items.empty() ? "none" : fmt::format("{}", fmt::join(items, ", "));
}

std::size_t place_of(const std::string& word, std::span<const char* const> words) {
  return static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

void fail_unknown(const std::string& word, std::span<const char* const> words, const char* what,
                  const std::string& where) {
  throw UsageError(fmt::format("unknown {} '{}'{} (known: {})", what, word, where.empty() ? "" : " in " + where,
                               fmt::join(words, ", ")));
}

}  // namespace mpmvv::support
