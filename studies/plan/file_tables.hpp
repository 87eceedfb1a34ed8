#pragma once
#include <string>
#include <vector>

#include "studies/support/toml_file.hpp"

namespace mpmvv::plan {

/// A key of a table in study files.
struct FileKey {
  std::string key;
  std::string takes;   ///< "two numbers"
  std::string absent;  ///< what counts without it; empty: there must be one
  std::string meaning;
};

/// A table of study files.
struct FileTable {
  std::string name;     ///< "figure"; empty: what stands at the top of the file
  std::string heading;  ///< "[[figure]]"
  std::string meaning;  ///< Markdown
  bool takes_settings;  ///< keys of settings beside its own
  std::vector<FileKey> keys;
};

/// All that may stand in a study file: the one place where its keys are named. Those of settings are others
/// (`cases::setting_keys`).
const std::vector<FileTable>& file_tables();

/// UsageError where the table has a key that those of this name do not take.
void require_known_keys(const support::TomlTable& table, const std::string& name);

}  // namespace mpmvv::plan
