#pragma once
#include <string>
#include <vector>

#include "studies/support/toml_file.hpp"

namespace mpmvv::plan {

/// A key of a table in study files.
struct FileKey {
  std::string key;
  std::string takes;   ///< "two numbers"
  std::string absent;  ///< what counts without it; empty: the key is required
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

/// All tables and keys of study files: the one place where they are named, except the keys of settings
/// (`cases::setting_keys`).
const std::vector<FileTable>& file_tables();

/// UsageError when `table` has a key that tables called `name` do not take. An empty name stands for the top of the
/// file.
void require_known_keys(const support::TomlTable& table, const std::string& name);

}  // namespace mpmvv::plan
