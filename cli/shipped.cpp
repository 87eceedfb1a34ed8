#include "cli/shipped.hpp"

#include <fmt/format.h>
#include <sys/auxv.h>

#include <algorithm>
#include <bit>
#include <system_error>

#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"
#include "studies/support/file.hpp"
#include "studies/support/suggestion.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::cli {

namespace fs = std::filesystem;
using records::StudyResult;
using support::UsageError;

namespace {

/// Whether something is there that may be a study file, as a folder may not.
bool may_be_read(const fs::path& file) {
  std::error_code unknown;
  const fs::file_status status = fs::status(file, unknown);
  return fs::exists(status) && !fs::is_directory(status);
}

[[noreturn]] void refuse_name(const std::string& name, const std::vector<std::string>& known) {
  const std::string file = name + ".toml";
  if (!study_names(name).empty()) throw UsageError(fmt::format("'{0}' is a folder (its studies: --studies {0})", name));
  const auto meant = may_be_read(file) ? file : support::nearest_word(name, known);
  throw UsageError(fmt::format("no study '{}' ({}a study file, or a name of `mpmvv list studies`)", name,
                               meant ? fmt::format("did you mean '{}'? ", *meant) : ""));
}

/// Whether it is a study file of this title: a file of the same name may be of anything.
bool has_title(const fs::path& file, const std::string& title) try {
  return support::TomlTable::read(file).text("title") == title;
} catch (const UsageError&) {
  return false;
}

}  // namespace

fs::path shipped(const std::string& folder) {
  std::error_code unknown;
  const auto* called = std::bit_cast<const char*>(getauxval(AT_EXECFN));  // also where /proc is not mounted
  const fs::path place = fs::canonical(called, unknown).parent_path();
  for (const fs::path& top : {place.parent_path() / "share" / "mpmvv", place.parent_path().parent_path()})
    if (fs::exists(top / "studies" / "quick.txt", unknown)) return top / folder;
  return {};
}

bool is_shipped(const StudyResult& study) {
  const fs::path folder = shipped("studies");
  return !folder.empty() && support::read_file(folder / (study.name + ".toml")) == store::without_trial(study.text);
}

std::vector<fs::path> files_named_as(const StudyResult& study) {
  std::vector<fs::path> files;
  for (const fs::path& folder : {fs::path(), fs::path("studies"), shipped("studies")})
    if (const fs::path file = folder / (study.name + ".toml"); may_be_read(file)) files.push_back(file);
  return files;
}

fs::path other_file(const StudyResult& study) {
  for (const fs::path& file : files_named_as(study))
    if (has_title(file, study.title))
      return support::read_file(file) == store::without_trial(study.text) ? fs::path() : file;
  return {};
}

fs::path goldens_for(const std::vector<StudyResult>& results, const std::string& named) {
  fs::path folder = named.empty() ? "goldens" : named;
  if (std::error_code unknown; named.empty() && !fs::exists(folder, unknown))
    return std::ranges::any_of(results, is_shipped) ? shipped("goldens") : folder;
  goldens::require_directory(folder);
  return folder;
}

std::vector<goldens::Golden> goldens_in(const fs::path& folder, const std::string& named) {
  if (named.empty() && !goldens::has_goldens(folder)) return {};
  return goldens::read_goldens(folder);
}

std::vector<std::string> study_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

void refuse_without_study(const std::string& folder) {
  if (folder.empty())
    throw UsageError(
        "this program finds no studies of its own (PREFIX/share/mpmvv/studies beside PREFIX/bin; --studies FOLDER)");
  std::error_code failed;
  fs::directory_iterator(folder, failed);
  throw UsageError(failed ? fmt::format("cannot read --studies {}: {} (a folder with *.toml)", folder, failed.message())
                          : fmt::format("no study file in --studies {} (a folder with *.toml)", folder));
}

std::vector<std::string> named_study_files(const std::vector<std::string>& names, const std::string& folder) {
  if (names.empty() && folder.empty())
    throw UsageError("no study named (study files, names of `mpmvv list studies`, or --studies FOLDER)");
  const fs::path place = folder.empty() ? shipped("studies") : fs::path(folder);
  const std::vector<std::string> known = study_names(place);
  if (known.empty() && !folder.empty()) refuse_without_study(folder);
  std::vector<std::string> files;
  for (const std::string& name : names.empty() ? known : names) {
    const bool is_there = !names.empty() && may_be_read(name);
    const bool by_name = !is_there && std::ranges::binary_search(known, name);
    const bool may_be_name = support::is_file_stem(name) || name.ends_with('/');
    if (!is_there && !by_name && may_be_name && !name.ends_with(".toml")) refuse_name(name, known);
    files.push_back(by_name ? (place / (name + ".toml")).string() : name);
  }
  return files;
}

}  // namespace mpmvv::cli
