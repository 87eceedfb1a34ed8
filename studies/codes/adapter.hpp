#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studies/codes/columns.hpp"

namespace mpmvv::codes {

/// A file of the code's input: the name under which it is written into a run's folder, and its mustache template.
struct InputFile {
  std::string file, text;
  std::filesystem::path source;  ///< of the template
};

/// A value that an adapter gives to its templates.
using FieldValues = std::map<std::string, std::string>;

/// How a program is found.
struct ProgramNames {
  std::string variable;  ///< of the environment, which names it
  std::string command;   ///< without that: on PATH, or with a '/' relative to the adapter's folder; may be empty
  std::vector<std::string> version;  ///< the command whose last output word is the version; empty: the file's digest
  std::string page;                  ///< where it says how to get and build it
};

/// What a code writes, and where. Names are templates.
struct OutputFiles {
  std::string format;                             ///< a word of `formats()`; empty: as the name's ending says
  std::string end;                                ///< file of the end time
  std::string start;                              ///< of time zero; empty: none
  std::vector<std::vector<std::string>> convert;  ///< commands that run after the code, each with its words
  Columns columns;
};

/// How a code comes to the end time.
struct Stepping {
  bool is_given = true;          ///< it takes the time step as it is told; else it chooses one of its own
  double time_tolerance = 1e-9;  ///< by which the time reached may differ from the end time, over that
};

/// What a code can do.
struct Capabilities {
  std::vector<int> dimensions;
  std::vector<std::string> force_forms, boundaries, materials;
  bool initial_velocity = false, initial_deformation = false;
};

/// How a code is put under the harness: `adapters/CODE/adapter.toml` and the templates beside it.
struct Adapter {
  std::string name;
  std::filesystem::path folder;
  ProgramNames program;
  std::vector<InputFile> inputs;
  std::vector<std::string> command;  ///< words, each a template
  std::map<std::string, std::string> environment;
  std::chrono::milliseconds time_limit{};
  std::vector<std::string> unstable;  ///< what the code says when the motion blew up; it is then no failure
  OutputFiles output;
  Stepping stepping;
  std::string dialect;                          ///< of expressions in the templates
  FieldValues fields;                           ///< of all variants
  std::map<std::string, FieldValues> variants;  ///< by their words
  Capabilities capabilities;
  std::string digest;  ///< of the file, all templates, and what commands name as `{{adapter}}/...`
};

/// Reads an adapter; every mistake is a UsageError with file and line.
Adapter read_adapter(const std::filesystem::path& file);

}  // namespace mpmvv::codes
