#include "tests/mutation/texts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "studies/support/printable.hpp"

namespace mpmvv::mutation {

namespace {

/// Words in lines of at most 100 columns, of which the first begins with `start` and the others are indented.
std::string in_lines(const std::string& start, std::size_t indentation, const std::string& words) {
  constexpr std::size_t width = 100;
  std::string text, line = start;
  std::istringstream in(support::printable(words));
  bool is_first = true;
  for (std::string word; in >> word; is_first = false) {
    if (!is_first && line.size() + 1 + word.size() > width) {
      text += line + "\n";
      line = std::string(indentation, ' ');
    } else if (!is_first) {
      line += ' ';
    }
    line += word;
  }
  return text + line + "\n";
}

constexpr std::size_t indented = 10;

std::string row(const std::string& label, const std::string& words) {
  return in_lines(fmt::format("{:<{}}", label, indented), indented, words);
}

std::string names_row(const char* what, const std::vector<std::string>& names) {
  return names.empty() ? "" : row("", fmt::format("{}: {}", what, fmt::join(names, ", ")));
}

std::string by_stage(const Catches& catches) {
  return fmt::format("{} by the unit tests, {} by the quick gate, {} by the nightly gate", catches.unit_tests,
                     catches.quick, catches.nightly);
}

}  // namespace

std::string text_of(const Mistake& mistake) {
  const std::string place =
      mistake.function.empty() ? mistake.file : fmt::format("{} of {}", mistake.function, mistake.file);
  return support::printable(
             fmt::format("{}  ({}{})", mistake.name, place, mistake.reason.empty() ? "" : ", equivalent")) +
         "\n" + in_lines("    ", 4, mistake.what);
}

std::string text_of(const Score& score) {
  std::string text =
      row("planted", fmt::format("{} should show, {} caught:", score.planted, score.planted_catches.any)) +
      row("", by_stage(score.planted_catches));
  if (score.equivalent > 0)
    text += row("", fmt::format("{} equivalent: efficiency or robustness only", score.equivalent));
  if (score.untried > 0) text += row("", fmt::format("{} not tried yet", score.untried));
  text += names_row("not caught", score.missed);
  if (score.random == 0) return text;
  text += row("random", fmt::format("{} tried, {} caught:", score.random, score.random_catches.any)) +
          row("", by_stage(score.random_catches)) +
          row("", fmt::format("{} survivors explained", score.random_explained));
  return text + names_row("not explained", score.unexplained);
}

}  // namespace mpmvv::mutation
