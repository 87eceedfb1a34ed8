#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace mpmvv::support {

/// The whole content; nullopt when the file is absent, cannot be read or is none, as a folder, a pipe or a device.
std::optional<std::string> read_file(const std::filesystem::path& file);

/// The same; where there is none a UsageError that says why, and what the file should be ("a TOML file").
std::string require_file(const std::filesystem::path& file, const std::string& wanted);

/// Writes the file unless it already has this content; true when it was written. The file appears whole or not at
/// all. Throws WriteError when it cannot be written.
bool write_if_changed(const std::filesystem::path& file, const std::string& content);

/// Gives the file or folder another name, in place of a file of that name. Throws WriteError when it cannot.
void move_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Names of studies and figures: the files of a report begin with them.
inline constexpr const char* file_stem_rule =
    "at most 100 letters, digits, '.', '_', '+' and '-', the first neither '.' nor '-'";
bool is_file_stem(const std::string& text);

/// Makes the folder and its parents; throws WriteError when that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace mpmvv::support
