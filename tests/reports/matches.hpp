#pragma once
#include <regex>
#include <string>
#include <vector>

namespace mpmvv::reports {

/// What the first group of a pattern takes of a text, wherever it matches.
inline std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> result;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) result.push_back((*it)[1]);
  return result;
}

}  // namespace mpmvv::reports
