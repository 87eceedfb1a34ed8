#include "studies/store/trial.hpp"

#include <fmt/format.h>

#include "studies/support/printable.hpp"

namespace mpmvv::store {

namespace {

constexpr std::string_view mark = "# Run with ";

}  // namespace

std::string with_trial(std::string text, const std::string& what) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text + fmt::format("{}{}\n", mark, support::printable(what));
}

/// The lines at the end that have the mark.
std::string trial_of(const std::string& text) {
  std::string trial;
  for (std::size_t end = text.size(); end > 0;) {
    const std::size_t newline = end < 2 ? std::string::npos : text.rfind('\n', end - 2);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    const std::string line = text.substr(begin, end - 1 - begin);
    if (!line.starts_with(mark)) break;
    trial = line.substr(mark.size()) + (trial.empty() ? "" : "; " + trial);
    end = begin;
  }
  return trial;
}

}  // namespace mpmvv::store
