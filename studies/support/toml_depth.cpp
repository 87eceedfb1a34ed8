#include "studies/support/toml_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "studies/support/error.hpp"

namespace mpmvv::support {

namespace {

constexpr int most_dots = 32, most_brackets = 64;

/// The place behind the quoted text that begins at `at`.
std::size_t after_quotes(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool of_many_lines = text.substr(at).starts_with(std::string(3, quote));
  const std::string end(of_many_lines ? 3 : 1, quote);
  for (std::size_t i = at + end.size(); i < text.size(); ++i) {
    if (text.substr(i).starts_with(end)) {
      std::size_t behind = i + end.size();
      const std::size_t last = of_many_lines ? std::min(behind + 2, text.size()) : behind;
      while (behind < last && text[behind] == quote) ++behind;  // up to two quotes of its own stand before its end
      return behind;
    }
    if (!of_many_lines && text[i] == '\n') return i;
    if (quote == '"' && text[i] == '\\') ++i;
  }
  return text.size();
}

bool is_of_key(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == ' ' || c == '\t';
}

}  // namespace

void require_shallow(std::string_view text, const std::string& name) {
  int dots = 0, brackets = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = after_quotes(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    dots = c == '.' ? dots + 1 : is_of_key(c) ? dots : 0;
    brackets = std::max(0, brackets + (c == '[' || c == '{') - (c == ']' || c == '}'));
    if (dots > most_dots || brackets > most_brackets)
      throw UsageError(fmt::format(
          "tables or arrays too deep in one another in {}:{} (at most {} keys joined by dots "
          "and {} brackets)",
          name, 1 + std::count(text.begin(), text.begin() + static_cast<long>(i), '\n'), most_dots + 1, most_brackets));
    ++i;
  }
}

}  // namespace mpmvv::support
