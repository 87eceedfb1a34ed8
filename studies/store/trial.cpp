#include "studies/store/trial.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <regex>
#include <string_view>

#include "studies/support/printable.hpp"

namespace mpmvv::store {

namespace {

constexpr std::string_view mark = "# mpmvv study --set: ", mark_in_older_stores = "# Run with ";

/// What a line says that this program has put under a study; nothing where the line is the study's own. People write
/// the older mark themselves ("# Run with care"), so there the whole line has to be as the program wrote it.
std::optional<std::string> trial_in(const std::string& line) {
  static const std::regex as_older_programs_wrote_it(R"(# Run with [\w.]+ = .* in \d+ of \d+ series)");
  if (line.starts_with(mark)) return line.substr(mark.size());
  if (std::regex_match(line, as_older_programs_wrote_it)) return line.substr(mark_in_older_stores.size());
  return std::nullopt;
}

/// The marked lines at the end of a text.
struct MarkedLines {
  std::size_t begin = 0;  ///< where they begin; without any the end of the text
  std::string trial;      ///< what they say
};

MarkedLines marked_lines_of(const std::string& text) {
  MarkedLines marked{text.size(), ""};
  while (marked.begin > 0) {
    const std::size_t end = text[marked.begin - 1] == '\n' ? marked.begin - 1 : marked.begin;
    const std::size_t newline = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    const auto trial = trial_in(text.substr(begin, end - begin));
    if (!trial) break;
    marked = {begin, *trial + (marked.trial.empty() ? "" : "; " + marked.trial)};
  }
  return marked;
}

}  // namespace

std::string with_trial(std::string text, const std::string& what) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text + fmt::format("{}{}\n", mark, support::printable(what));
}

std::string without_trial(const std::string& text) {
  return text.substr(0, marked_lines_of(text).begin);
}

std::string trial_of(const std::string& text) {
  return marked_lines_of(text).trial;
}

}  // namespace mpmvv::store
