#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace mpmvv {

/// The whole content; nullopt when the file is absent or cannot be read.
std::optional<std::string> read_file(const std::filesystem::path& file);

/// Writes the file unless it already has this content; true when it was written. The file appears whole or not at
/// all. Throws UsageError when it cannot be written.
bool write_if_changed(const std::filesystem::path& file, const std::string& content);

/// Gives the file or folder another name, in place of a file of that name. Throws UsageError when it cannot.
void move_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes the folder and its parents; throws UsageError when that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace mpmvv
