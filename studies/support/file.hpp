#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace mpmvv::support {

/// The whole content; nullopt when the file is absent, cannot be read or is no regular file (a folder, a pipe or a
/// device).
std::optional<std::string> read_file(const std::filesystem::path& file);

/// The same, but throws a UsageError instead of nullopt. It says why, and what the file should be: `wanted`, "a TOML
/// file".
std::string require_file(const std::filesystem::path& file, const std::string& wanted);

/// Writes the file, or what a symbolic link points to, unless it already has this content; true when it was written.
/// The file appears whole or not at all, no other file changes, and who may read and write it stays so. Throws
/// WriteError when it cannot be written.
bool write_if_changed(const std::filesystem::path& file, const std::string& content);

/// Renames a file or folder, replacing a file that has the new name. Throws WriteError when it cannot.
void move_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// The rule for names of studies and figures: names of a report's files begin with them.
inline constexpr const char* file_stem_rule =
    "at most 100 letters, digits, '.', '_', '+' and '-', the first neither '.' nor '-'";
bool is_file_stem(const std::string& text);

/// Makes the folder and its parents; throws WriteError when that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace mpmvv::support
