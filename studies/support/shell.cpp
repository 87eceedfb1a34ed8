#include "studies/support/shell.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace mpmvv::support {

std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string shell_word(const std::string& text) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_./-+=,:@%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  return !text.empty() && std::ranges::all_of(text, is_plain) ? text : shell_quoted(text);
}

}  // namespace mpmvv::support
