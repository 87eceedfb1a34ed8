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

/// Names of studies and figures: the files of a report begin with them.
inline constexpr const char* file_stem_rule =
    "at most 100 letters, digits, '.', '_', '+' and '-', the first neither '.' nor '-'";
bool is_file_stem(const std::string& text);

/// Makes the folder and its parents; throws UsageError when that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace mpmvv
