#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "goldens/golden.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::cli {

/// The folder of this name (`studies`, `goldens`, `adapters`, `tests/mutation`) that comes with the program:
/// PREFIX/share/mpmvv/... of a program in PREFIX/bin, else that of the tree in which it was built. Empty where neither
/// is there.
std::filesystem::path shipped(const std::string& folder);

/// Whether these are the results of a study that comes with the program, word for word, as it is or as a trial.
bool is_shipped(const records::StudyResult& study);

/// The files of the study's name: here, in `studies` here, and among those that come with the program.
std::vector<std::filesystem::path> files_named_as(const records::StudyResult& study);

/// The first of them that has the study's title, too, if it is not word for word what was run. Empty where it is, and
/// where there is none.
std::filesystem::path other_file(const records::StudyResult& study);

/// The folder of goldens that results are held against: the one named, UsageError where it is not there; without a name
/// `goldens` here or, where there is none and a result is of a study that comes with the program, the folder that comes
/// with it.
std::filesystem::path goldens_for(const std::vector<records::StudyResult>& results, const std::string& named);
inline constexpr const char* default_goldens = "default: goldens here, else those of the program for its own studies";

/// The goldens of that folder. Unless it was named it may have none: the first results of a study come before its first
/// golden.
std::vector<goldens::Golden> goldens_in(const std::filesystem::path& folder, const std::string& named);

/// Names of the studies in a folder, in their order; none where there is no folder.
std::vector<std::string> study_names(const std::filesystem::path& folder);

/// Throws the UsageError for a folder of `--studies` in which there is no study file, or which cannot be read.
[[noreturn]] void refuse_without_study(const std::string& folder);

/// The study files that a user names, by their paths or, in a folder and among those that come with the program, by
/// their names alone; all of the folder where none is named. UsageError where there is none.
std::vector<std::string> named_study_files(const std::vector<std::string>& names, const std::string& folder);

}  // namespace mpmvv::cli
