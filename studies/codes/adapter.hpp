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
  std::filesystem::path source;  ///< the file of the template
  bool in_units = false;         ///< whether its numbers are in the units of the output, and not in m, s, kg
};

/// Values that an adapter gives to its templates. None has the name of a field of the case.
using FieldValues = std::map<std::string, std::string>;

/// How the program of a code, and its version, are found.
struct ProgramNames {
  std::string variable;  ///< the environment variable that names the program
  std::string command;   ///< the default program: on PATH, or with a '/' from the adapter's folder; may be empty
  std::vector<std::string> version;  ///< command whose last output word is the version; empty: the file's digest is it
  std::string page;                  ///< the page that says how to get and build the program
};

/// The files that a code writes. Names of files are templates.
struct OutputFiles {
  std::string format;  ///< a word of `formats()`; empty: the format that the file name's ending says
  std::string end;     ///< the file with the particles at the end time
  std::string start;   ///< the file with the particles at time zero; empty: none
  std::vector<std::vector<std::string>> convert;  ///< the words of each command that runs after the code
  Columns columns;
  bool are_parts = false;  ///< whether all files that match a name are parts of one state; if not, the last is read
};

/// How a code steps to the end time.
struct Stepping {
  bool is_given = true;          ///< whether it takes the given time step; if not, it chooses its own
  double time_tolerance = 1e-9;  ///< largest |time reached - end time| over the end time
};

/// The cases that a code can run.
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
  std::vector<std::string> unstable;  ///< texts that the code prints when the motion blew up, which is no failure
  OutputFiles output;
  Stepping stepping;
  std::string dialect;                          ///< the dialect of expressions in the templates; empty: they have none
  FieldValues fields;                           ///< values for the templates, the same for all variants
  std::map<std::string, FieldValues> variants;  ///< further values, by the word of the variant
  Capabilities capabilities;
  std::string digest;  ///< digest of this file, all templates, and files that commands name as `{{adapter}}/...`
};

/// Reads an adapter. Throws UsageError with file and line for any mistake in it.
Adapter read_adapter(const std::filesystem::path& file);

}  // namespace mpmvv::codes
