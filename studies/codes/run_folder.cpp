#include "studies/codes/run_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <set>
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

/// A path at which nothing is yet: another machine or container may have had a process of this number.
fs::path free_path(const char* what) {
  static std::atomic<int> count = 0;
  const std::string begin = beginning(what);
  std::error_code absent;
  fs::path path;
  do path = fmt::format("{}{}", begin, ++count);
  while (fs::exists(path, absent));
  return path;
}

/// A folder that nobody else has.
fs::path new_folder() {
  std::error_code failed;
  fs::path path;
  do path = free_path("run");
  while (!fs::create_directory(path, failed) && !failed);
  return path;
}

/// The temporary folders of this process.
class Temporary {
 public:
  void add(const fs::path& folder) {
    const std::lock_guard lock(mutex_);
    folders_.insert(folder);
  }
  void forget(const fs::path& folder) {
    const std::lock_guard lock(mutex_);
    folders_.erase(folder);
  }
  void remove_all() {
    const std::lock_guard lock(mutex_);
    std::error_code ignored;
    for (const fs::path& folder : folders_) fs::remove_all(folder, ignored);
  }

 private:
  std::mutex mutex_;
  std::set<fs::path> folders_;
};

Temporary& temporary() {
  static Temporary all;
  return all;
}

}  // namespace

RunFolder::RunFolder(const fs::path& named)
    : path_(named.empty() ? new_folder() : fs::absolute(named)), is_temporary_(named.empty()) {
  support::make_folder(path_);  // of a new one that could not be made it says why
  if (is_temporary_) temporary().add(path_);
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  if (!is_temporary_) return;
  fs::remove_all(path_, ignored);
  temporary().forget(path_);
}

fs::path RunFolder::keep() {
  if (!is_temporary_) return path_;
  const fs::path place = free_path("failed");
  support::move_file(path_, place);
  temporary().forget(path_);
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
  temporary().remove_all();
}

}  // namespace mpmvv::codes
