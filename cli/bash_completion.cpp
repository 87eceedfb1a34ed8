#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "cli/completion.hpp"

namespace mpmvv::cli {

namespace {

/// Calls visit(command) for the program and every command below it.
template <class Visit>
void for_each_command(const CommandText& command, const Visit& visit) {
  visit(command);
  for (const CommandText& inner : command.commands) for_each_command(inner, visit);
}

std::vector<std::string> flags_of(const CommandText& command) {
  std::vector<std::string> flags;
  for (const ArgumentText& option : command.options)
    flags.insert(flags.end(), option.flags.begin(), option.flags.end());
  return flags;
}

/// What the script says of an argument's values; empty where nothing is known of them.
std::string action_of(const ArgumentText& argument) {
  std::string action;
  if (!argument.words.empty()) action = fmt::format("words='{}'", fmt::join(argument.words, " "));
  if (argument.takes_folders()) action = "paths=-d";
  if (argument.takes_files()) action += action.empty() ? "paths=-f" : argument.flags.empty() ? " paths=-f" : "";
  return action;
}

std::string value_cases(const CommandText& program) {
  std::string cases;
  for_each_command(program, [&](const CommandText& command) {
    for (const ArgumentText& option : command.options)
      for (const std::string& flag : option.flags)
        if (!option.value.empty())
          cases += fmt::format("    '{} {}') takes_value=1 {} ;;\n", command.path, flag, action_of(option));
  });
  return cases;
}

/// What stands where no option does: a command, or a positional argument.
std::string word_cases(const CommandText& program) {
  std::string cases;
  for_each_command(program, [&](const CommandText& command) {
    std::vector<std::string> names;
    for (const CommandText& inner : command.commands) names.push_back(inner.name);
    std::set<std::string> actions;
    if (!names.empty()) actions.insert(fmt::format("words='{}'", fmt::join(names, " ")));
    for (const ArgumentText& positional : command.positionals) actions.insert(action_of(positional));
    cases += fmt::format("    '{}') options='{}' {} ;;\n", command.path, fmt::join(flags_of(command), " "),
                         fmt::join(actions, " "));
  });
  return cases;
}

std::string command_patterns(const CommandText& program) {
  std::vector<std::string> patterns;
  for_each_command(program, [&](const CommandText& command) {
    if (!command.path.empty()) patterns.push_back(fmt::format("'{}'", command.path));
  });
  return fmt::format("{}", fmt::join(patterns, " | "));
}

constexpr const char* bash_script = R"(# Completion of mpmvv for bash, made by `mpmvv completion bash`.
_mpmvv() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command='' options='' words='' paths='' takes_value='' k
  if [[ $current == = ]]; then
    current=''
  elif [[ $previous == = ]]; then
    previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  for ((k = 1; k < COMP_CWORD; ++k)); do
    case "${{command:+$command }}${{COMP_WORDS[k]}}" in
      {patterns}) command=${{command:+$command }}${{COMP_WORDS[k]}} ;;
    esac
  done
  case "$command $previous" in
{values}  esac
  if [[ -z $takes_value ]]; then
    case "$command" in
{words}    esac
    [[ $current == -* || -z $words$paths ]] && words=$options paths=''
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"; [[ -z $paths ]] || compgen "$paths" -- "$current")
  [[ -z $paths ]] || compopt -o filenames 2> /dev/null
}}
complete -F _mpmvv mpmvv
)";

}  // namespace

std::string bash_completion(const CommandText& program) {
  return fmt::format(bash_script, fmt::arg("patterns", command_patterns(program)),
                     fmt::arg("values", value_cases(program)), fmt::arg("words", word_cases(program)));
}

}  // namespace mpmvv::cli
