#include "reports/study_call.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/support/shell.hpp"

namespace mpmvv::reports {

std::string study_command(const std::vector<StudyCall>& calls, const std::string& db, const std::string& db_of_trials) {
  std::vector<StudyCall> commands;  // studies of the same options together
  for (const StudyCall& call : calls) {
    auto command = std::ranges::find(commands, call.options, &StudyCall::options);
    if (command == commands.end()) command = commands.insert(commands.end(), {"", call.options});
    command->study += " " + support::shell_word(call.study);
  }
  std::string text;
  for (const auto& [studies, options] : commands)
    text += fmt::format("{}mpmvv study{}{} --db {}", text.empty() ? "" : " && ", studies, options,
                        support::shell_word(options.empty() ? db : db_of_trials));
  return text;
}

}  // namespace mpmvv::reports
