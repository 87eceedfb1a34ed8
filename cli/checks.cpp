#include "cli/checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "studies/cases/setting.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

/// The validator's description lists the words: completions take them from there.
CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto objection = [words](const std::string& text) {
    return std::ranges::count(words, text) > 0
               ? ""
               : fmt::format("unknown word '{}' (known: {})", text, fmt::join(words, ", "));
  };
  return {objection, fmt::format("{{{}}}", fmt::join(words, ","))};
}

std::string word_of(const std::vector<std::string>& words) {
  return fmt::format("WORD:{{{}}}", fmt::join(words, ","));
}

CLI::Validator from_to(std::int64_t least, std::int64_t most) {
  const auto objection = [least, most](const std::string& text) {
    try {
      cases::whole({"", text, ""}, least, most);
    } catch (const support::UsageError&) {
      return fmt::format("{} (a whole number from {} to {})", text, least, most);
    }
    return std::string();
  };
  return {objection, ""};
}

}  // namespace mpmvv::cli
