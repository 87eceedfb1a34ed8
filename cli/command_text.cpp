#include "cli/command_text.hpp"

#include <algorithm>
#include <sstream>

#include "cli/command.hpp"
#include "cli/setting_words.hpp"
#include "cli/shipped.hpp"

namespace mpmvv::cli {

namespace {

/// "a,b" of "TEXT:{a,b}", as CLI11 shows an option that takes certain words.
std::vector<std::string> words_in_braces(const std::string& type) {
  const auto begin = type.find('{'), end = type.find('}');
  std::vector<std::string> words;
  if (begin == std::string::npos || end == std::string::npos) return words;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  return words;
}

/// "WORD" of "WORD:{a,b}".
std::string kind_of(const std::string& type) {
  return type.substr(0, type.find(':'));
}

/// The words of the setting that the option stands for, or those that it names itself. An option of a setting's name
/// may take something else: `score --start` takes files.
std::vector<std::string> words_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  if (type == "STUDY" || option.get_name(true) == "files") return study_names(shipped("studies"));
  if (type == "LIST") return list_names();
  std::string key = option.get_lnames().empty() ? "" : option.get_lnames().front();
  std::ranges::replace(key, '-', '_');
  const auto words = kind_of(type) == "WORD" ? setting_words(key) : std::vector<std::string>{};
  return words.empty() ? words_in_braces(type) : words;
}

ArgumentText argument_text(const CLI::Option& option) {
  ArgumentText text;
  for (const std::string& name : option.get_snames()) text.flags.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.flags.push_back("--" + name);
  if (option.get_positional()) text.name = option.get_name(true);
  const std::string type = option.get_type_name();
  if (option.get_items_expected_max() > 0) text.value = type.empty() ? "VALUE" : kind_of(type);
  text.meaning = option.get_description();
  if (!option.get_default_str().empty()) text.meaning += " (default: " + option.get_default_str() + ")";
  text.words = words_of(option);
  text.required = option.get_required();
  text.repeatable = option.get_items_expected_max() > 1;
  return text;
}

CommandText text_of(const CLI::App& command, const std::string& path) {
  CommandText text{command.get_name(), path, command.get_description(), command.get_footer(), {}, {}, {}};
  for (const CLI::Option* option : command.get_options())
    (option->get_positional() ? text.positionals : text.options).push_back(argument_text(*option));
  for (const CLI::App* inner : command.get_subcommands({}))
    if (!inner->get_group().empty())
      text.commands.push_back(text_of(*inner, path.empty() ? inner->get_name() : path + " " + inner->get_name()));
  return text;
}

}  // namespace

CommandText command_text(const CLI::App& program) {
  return text_of(program, "");
}

}  // namespace mpmvv::cli
