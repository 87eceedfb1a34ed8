#include "cli/shipped.hpp"

#include <fmt/format.h>
#include <sys/auxv.h>

#include <algorithm>
#include <system_error>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::cli {

namespace fs = std::filesystem;
using records::StudyResult;
using support::UsageError;

namespace {

/// Study files of a folder, in the order of their names.
std::vector<std::string> all_of(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  if (files.empty()) throw UsageError(fmt::format("no study file in --studies {} (a folder with *.toml)", folder));
  std::ranges::sort(files);
  return files;
}

}  // namespace

fs::path shipped(const std::string& folder) {
  std::error_code unknown;
  const auto* called = reinterpret_cast<const char*>(getauxval(AT_EXECFN));  // also where /proc is not mounted
  const fs::path place = fs::canonical(called, unknown).parent_path();
  for (const fs::path& top : {place.parent_path() / "share" / "mpmvv", place.parent_path().parent_path()})
    if (fs::exists(top / "studies" / "quick.txt", unknown)) return top / folder;
  return {};
}

bool is_shipped(const StudyResult& study) {
  const fs::path folder = shipped("studies");
  return !folder.empty() && support::read_file(folder / (study.name + ".toml")) == study.text;
}

fs::path goldens_for(const std::vector<StudyResult>& results, const std::string& named) {
  if (!named.empty()) return named;
  std::error_code unknown;
  const fs::path here = "goldens";
  return fs::exists(here, unknown) || std::ranges::none_of(results, is_shipped) ? here : shipped("goldens");
}

std::vector<std::string> named_study_files(const std::vector<std::string>& names, const std::string& folder) {
  if (names.empty() && folder.empty())
    throw UsageError("no study named (study files, names of studies that come with the program, or --studies DIR)");
  if (names.empty()) return all_of(folder);
  std::vector<std::string> files;
  for (const std::string& name : names) {
    const fs::path in_folder = (folder.empty() ? shipped("studies") : fs::path(folder)) / (name + ".toml");
    std::error_code unknown;
    files.push_back(!fs::exists(name, unknown) && fs::exists(in_folder, unknown) ? in_folder.string() : name);
  }
  return files;
}

}  // namespace mpmvv::cli
