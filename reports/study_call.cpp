#include "reports/study_call.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>

namespace mpmvv::reports {

namespace {

/// The text, in quotes where a shell would not take it for one word.
std::string shell_word(const std::string& text) {
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) != 0 || std::strchr("_./-+=,:@%", c) != nullptr; };
  if (std::ranges::all_of(text, is_plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

}  // namespace

std::string study_command(const std::vector<StudyCall>& calls, const std::string& db, const std::string& db_of_trials) {
  std::vector<StudyCall> commands;  // studies of the same options together
  for (const StudyCall& call : calls) {
    auto command = std::ranges::find(commands, call.options, &StudyCall::options);
    if (command == commands.end()) command = commands.insert(commands.end(), {"", call.options});
    command->study += " " + shell_word(call.study);
  }
  std::string text;
  for (const auto& [studies, options] : commands)
    text += fmt::format("{}mpmvv study{}{} --db {}", text.empty() ? "" : " && ", studies, options,
                        shell_word(options.empty() ? db : db_of_trials));
  return text;
}

}  // namespace mpmvv::reports
