#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace mpmvv::cli {

/// An option or a positional argument, as its command defines it.
struct ArgumentText {
  std::vector<std::string> flags;  ///< "-h", "--help"; none for a positional one
  std::string name;                ///< of a positional one
  std::string value;               ///< what an option takes, "FILE"; empty for a flag
  std::string meaning;
  std::vector<std::string> words;  ///< those that it takes, where it takes words
  bool required = false, repeatable = false;

  bool takes_folders() const { return value == "FOLDER"; }
  bool takes_files() const { return value == "FILE" || value == "PROGRAM"; }
};

/// A command, as the man page and the completions of shells show it.
struct CommandText {
  std::string name;  ///< "info"
  std::string path;  ///< "db info"; empty for the program itself
  std::string meaning, footer;
  std::vector<ArgumentText> positionals, options;
  std::vector<CommandText> commands;
};

/// The program with all of its commands but the hidden ones (of no group).
CommandText command_text(const CLI::App& program);

}  // namespace mpmvv::cli
