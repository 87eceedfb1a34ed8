#include "cli/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "cli/console.hpp"
#include "cli/lines.hpp"

namespace mpmvv::cli {

namespace {

/// A name with its meaning beside it, or below where the name is long.
std::string described(const std::string& name, const std::string& meaning) {
  constexpr std::size_t column = 26;
  std::string text = padded("  " + name, column, Align::left);
  if (!text.ends_with("  ")) text += '\n' + std::string(column, ' ');
  const auto lines = wrapped(meaning, text_width() - column);
  return text + fmt::format("{}\n", fmt::join(lines, '\n' + std::string(column, ' ')));
}

std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  return fmt::format("{}", fmt::join(names, ", "));
}

/// A call in as many lines as it takes, broken before options, as a shell reads it.
std::string continued(const std::string& call) {
  const std::string end = " \\", indent(6, ' ');
  if (columns_of(call) <= text_width()) return call;
  std::string text, line;
  for (std::size_t begin = 0; begin < call.size();) {
    const std::size_t next = std::min(call.find(" -", begin + 1), call.size());
    const std::string part = call.substr(begin, next - begin);
    if (!line.empty() && columns_of(line + part + end) > text_width())
      text += line + end + '\n', line = indent + part.substr(1);
    else
      line += part;
    begin = next;
  }
  return text + line;
}

}  // namespace

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  return described(make_option_name(option, is_positional) + make_option_opts(option), make_option_desc(option));
}

/// The kind of value without what checks say of it, and whether there may be several.
std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size() == 0) return "";
  const std::string type = option->get_type_name();
  const bool several = option->get_expected_max() >= CLI::detail::expected_max_vector_size;
  return (type.empty() ? "" : ' ' + type.substr(0, type.find(':'))) + (several ? " ..." : "");
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  std::string meaning = option->get_description();
  if (!option->get_default_str().empty()) meaning += fmt::format(" (default: {})", option->get_default_str());
  if (option->get_required()) meaning += " (required)";
  if (!option->get_needs().empty()) meaning += fmt::format(" (with {})", names_of(option->get_needs()));
  if (!option->get_excludes().empty()) meaning += fmt::format(" (not with {})", names_of(option->get_excludes()));
  return meaning;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return described(command->get_name(), command->get_description());
}

std::string HelpFormatter::make_description(const CLI::App* command) const {
  return fmt::format("{}\n", fmt::join(wrapped(command->get_description(), text_width()), "\n"));
}

std::string HelpFormatter::make_footer(const CLI::App* command) const {
  std::istringstream footer(command->get_footer());
  std::string text;
  for (std::string line; std::getline(footer, line);) text += continued(line) + '\n';
  return text;
}

void add_examples(CLI::App& command, const std::vector<std::string>& calls) {
  command.footer(fmt::format("Examples:\n  {}", fmt::join(calls, "\n  ")));
}

}  // namespace mpmvv::cli
