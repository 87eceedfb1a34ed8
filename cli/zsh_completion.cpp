#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/completion.hpp"

namespace mpmvv::cli {

namespace {

/// A text inside single quotes, with a backslash before what `_arguments` takes for its own.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return out;
}

/// "_mpmvv_db_info" of "db info".
std::string function_of(const CommandText& command) {
  std::string name = command.path.empty() ? "_mpmvv" : "_mpmvv_" + command.path;
  std::ranges::replace(name, ' ', '_');
  return name;
}

/// "value:(a b)", what `_arguments` is told of an argument's values. A positional one may take words and files.
std::string zsh_values(const ArgumentText& argument) {
  const std::string label = escaped(argument.flags.empty() ? argument.name : argument.value);
  const std::string words = fmt::format("{}", fmt::join(argument.words, " "));
  std::string action;
  if (!words.empty()) action = fmt::format("({})", words);
  if (argument.takes_folders()) action = "_files -/";
  if (argument.takes_files() && words.empty()) action = "_files";
  if (argument.takes_files() && !words.empty() && argument.flags.empty())
    action = fmt::format("{{ compadd -- {}; _files }}", words);
  return fmt::format("{}:{}", label, action);
}

std::string option_lines(const CommandText& command) {
  std::string lines;
  for (const ArgumentText& option : command.options)
    for (const std::string& flag : option.flags) {
      const std::string value = option.value.empty() ? "" : ":" + zsh_values(option);
      const char* equals = !value.empty() && flag.starts_with("--") ? "=" : "";  // "--db FILE" and "--db=FILE"
      lines += fmt::format("    '{}{}{}[{}]{}' \\\n", option.repeatable ? "*" : "", flag, equals,
                           escaped(option.meaning), value);
    }
  return lines;
}

std::string positional_lines(const CommandText& command) {
  std::string lines;
  for (const ArgumentText& positional : command.positionals)
    lines += fmt::format("    '{}:{}' \\\n", positional.repeatable ? "*" : "", zsh_values(positional));
  return lines;
}

std::string function_text(const CommandText& command) {
  if (command.commands.empty())
    return fmt::format("{}() {{\n  _arguments -s \\\n{}{}    && return\n}}\n\n", function_of(command),
                       option_lines(command), positional_lines(command));
  std::string names, calls, functions;
  for (const CommandText& inner : command.commands) {
    names += fmt::format("        '{}:{}'\n", inner.name, escaped(inner.meaning));
    calls += fmt::format("        {}) {} ;;\n", inner.name, function_of(inner));
    functions += function_text(inner);
  }
  return functions + fmt::format(R"({0}() {{
  local state line context
  _arguments -C \
{1}    '1:command:->command' \
    '*::argument:->argument'
  case $state in
    command)
      local -a commands=(
{2}      )
      _describe command commands
      ;;
    argument)
      case $line[1] in
{3}      esac
      ;;
  esac
}}

)",
                                 function_of(command), option_lines(command), names, calls);
}

}  // namespace

std::string zsh_completion(const CommandText& program) {
  return "#compdef mpmvv\n# Completion of mpmvv for zsh, made by `mpmvv completion zsh`.\n" + function_text(program) +
         "_mpmvv \"$@\"\n";
}

}  // namespace mpmvv::cli
