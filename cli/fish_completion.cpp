#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/completion.hpp"

namespace mpmvv::cli {

namespace {

std::string fish_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

/// The condition under which a command is the one that is being written: the line begins with its words and, where it
/// has commands of its own, ends with them. A file may be called as a command is.
std::string condition_of(const CommandText& command) {
  const std::string words = command.path.empty() ? "" : " " + command.path;
  return fish_quoted((command.commands.empty() ? "__mpmvv_begins" : "__mpmvv_is") + words);
}

constexpr const char* fish_conditions = R"(function __mpmvv_begins
  set -l words (commandline -opc)
  test (count $words) -gt (count $argv); or return 1
  for k in (seq (count $argv))
    test $words[(math $k + 1)] = $argv[$k]; or return 1
  end
end
function __mpmvv_is
  test (count (commandline -opc)) -eq (math (count $argv) + 1); and __mpmvv_begins $argv
end
)";

/// What follows an option or stands without one.
std::string fish_values(const ArgumentText& argument) {
  if (!argument.words.empty()) return " -a " + fish_quoted(fmt::format("{}", fmt::join(argument.words, " ")));
  return argument.takes_folders() ? " -a '(__fish_complete_directories)'" : "";
}

std::string fish_option(const std::string& start, const ArgumentText& option) {
  std::string line = start;
  for (const std::string& flag : option.flags)
    line += flag.starts_with("--") ? " -l " + flag.substr(2) : " -s " + flag.substr(1);
  if (!option.value.empty())
    line += (option.takes_files() && option.words.empty() ? " -rF" : " -x") + fish_values(option);
  return fmt::format("{} -d {}\n", line, fish_quoted(option.meaning));
}

std::string fish_lines(const CommandText& command) {
  const std::string start = "complete -c mpmvv -n " + condition_of(command);
  std::string lines;
  for (const CommandText& inner : command.commands)
    lines += fmt::format("{} -a {} -d {}\n", start, inner.name, fish_quoted(inner.meaning));
  for (const ArgumentText& option : command.options) lines += fish_option(start, option);
  for (const ArgumentText& positional : command.positionals) {
    if (positional.takes_files()) lines += start + " -F\n";
    if (!positional.words.empty()) lines += start + fish_values(positional) + "\n";
  }
  for (const CommandText& inner : command.commands) lines += fish_lines(inner);
  return lines;
}

}  // namespace

std::string fish_completion(const CommandText& program) {
  return std::string("# Completion of mpmvv for fish, made by `mpmvv completion fish`.\n") + fish_conditions +
         "complete -c mpmvv -f\n" + fish_lines(program);
}

}  // namespace mpmvv::cli
