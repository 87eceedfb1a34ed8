#include "studies/codes/run_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <system_error>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;

namespace {

/// Beginning of the paths of this process's folders: of the runs that go on, or of those that failed.
std::string beginning(const char* what) {
  return (place_of_runs() / fmt::format("mpmvv-{}-{}-", what, getpid())).string();
}

/// Of a run, in this process.
int next_number() {
  static std::atomic<int> count = 0;
  return ++count;
}

}  // namespace

RunFolder::RunFolder(const fs::path& named) : number_(next_number()), is_temporary_(named.empty()) {
  path_ = is_temporary_ ? fs::path(fmt::format("{}{}", beginning("run"), number_)) : fs::absolute(named);
  support::make_folder(path_);
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  if (!is_temporary_) return;
  fs::remove_all(path_, ignored);
}

fs::path RunFolder::keep() {
  if (!is_temporary_) return path_;
  const fs::path place = fmt::format("{}{}", beginning("failed"), number_);
  support::move_file(path_, place);
  path_ = place;
  is_temporary_ = false;
  return place;
}

fs::path place_of_runs() {
  std::error_code failed;
  const fs::path place = fs::temp_directory_path(failed);
  if (!failed) return place;
  const char* named = std::getenv("TMPDIR");
  throw support::UsageError(
      fmt::format("TMPDIR is '{}', which is no folder (one that is there and can be written)", named ? named : "/tmp"));
}

void remove_run_folders() {
  std::error_code ignored;
  const fs::path first = beginning("run");
  for (const auto& entry : fs::directory_iterator(first.parent_path(), ignored))
    if (entry.path().string().starts_with(first.string())) fs::remove_all(entry.path(), ignored);
}

}  // namespace mpmvv::codes
