#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mpmvv::cli {

/// UsageError where `output`, a file or a folder that `option` names, is or holds one of the inputs, under whatever
/// name: files are compared as they are on the disk, not by name. Of an input that is a folder, every file in it
/// counts.
void require_apart(const std::string& option, const std::filesystem::path& output,
                   const std::vector<std::filesystem::path>& inputs);

/// UsageError where two options name the same file to write.
void require_apart(const std::string& option, const std::filesystem::path& output, const std::string& other_option,
                   const std::filesystem::path& other_output);

/// UsageError where the file that `option` names is a pipe that the caller has not opened for this program, which would
/// let it wait, perhaps for ever, until somebody reads.
void require_writable_at_once(const std::string& option, const std::filesystem::path& file);

/// Writes the text into the file that `option` names. UsageError where that is a file which does not begin as the text
/// does: it is of another kind, and the name is a slip. So is a pipe, unless the caller has opened it for this program.
void write_output(const std::string& option, const std::filesystem::path& file, const std::string& text);

}  // namespace mpmvv::cli
