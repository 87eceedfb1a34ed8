#include "studies/store/trial.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/support/printable.hpp"

namespace mpmvv::store {

namespace {

constexpr std::string_view mark = "# Run with ";

/// Where the marked lines at the end of the text begin; the end of the text without any.
std::size_t begin_of_trial(const std::string& text) {
  std::size_t begin = text.size();
  while (begin > 0) {
    const std::size_t newline = begin < 2 ? std::string::npos : text.rfind('\n', begin - 2);
    const std::size_t line = newline == std::string::npos ? 0 : newline + 1;
    if (text.compare(line, mark.size(), mark) != 0) break;
    begin = line;
  }
  return begin;
}

}  // namespace

std::string with_trial(std::string text, const std::string& what) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text + fmt::format("{}{}\n", mark, support::printable(what));
}

std::string without_trial(const std::string& text) {
  return text.substr(0, begin_of_trial(text));
}

std::string trial_of(const std::string& text) {
  std::string trial;
  for (std::size_t begin = begin_of_trial(text); begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    trial += (trial.empty() ? "" : "; ") + text.substr(begin + mark.size(), end - begin - mark.size());
    begin = end + 1;
  }
  return trial;
}

}  // namespace mpmvv::store
