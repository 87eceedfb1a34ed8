#include "studies/codes/run_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <set>
#include <system_error>
#include <thread>

#include "studies/support/error.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;

namespace {

/// Returns the beginning of the paths of this process's folders. `what` is run for runs that go on, failed for others.
std::string beginning(const char* what) {
  return (place_of_runs() / fmt::format("mpmvv-{}-{}-", what, getpid())).string();
}

/// Returns a path that is still free: a process with the same number, on another machine or in another
/// container, may have left some.
fs::path free_path(const char* what) {
  static std::atomic<int> count = 0;
  const std::string begin = beginning(what);
  std::error_code absent;
  fs::path path;
  do path = fmt::format("{}{}", begin, ++count);
  while (fs::exists(path, absent));
  return path;
}

/// Makes a folder that nobody else has. If it cannot, there is no folder at the path that it returns.
fs::path new_folder() {
  std::error_code failed;
  fs::path path;
  do path = free_path("run");
  while (!fs::create_directory(path, failed) && !failed);
  return path;
}

/// The temporary folders of this process. They are made and removed under the lock.
struct Temporary {
  std::mutex mutex;
  std::set<fs::path> folders;
};

Temporary& temporary() {
  static Temporary all;
  return all;
}

/// Removes the folder, if need be in several tries: a process that has been killed may write a last file while it is
/// being removed.
void remove_surely(const fs::path& folder) {
  constexpr std::chrono::milliseconds wait{10};
  std::error_code failed;
  for (int k = 0; k < 100; ++k) {
    fs::remove_all(folder, failed);
    if (!failed) return;
    std::this_thread::sleep_for(wait);
  }
}

}  // namespace

RunFolder::RunFolder(const fs::path& named) : is_temporary_(named.empty()) {
  const std::lock_guard lock(temporary().mutex);
  path_ = is_temporary_ ? new_folder() : fs::absolute(named);
  support::make_folder(path_);  // throws, with the reason, if the new folder could not be made
  if (is_temporary_)
    temporary().folders.insert(path_);
  else if (!fs::is_empty(path_))
    throw support::UsageError(
        fmt::format("{} in --keep is not empty (a new folder, or an empty one: files of an earlier run would be taken "
                    "for this one's)",
                    named.string()));
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  if (!is_temporary_) return;
  const std::lock_guard lock(temporary().mutex);
  fs::remove_all(path_, ignored);
  temporary().folders.erase(path_);
}

fs::path RunFolder::keep() {
  if (!is_temporary_) return path_;
  const std::lock_guard lock(temporary().mutex);
  fs::path place = free_path("failed");
  support::move_file(path_, place);
  temporary().folders.erase(path_);
  path_ = place;
  is_temporary_ = false;
  return place;
}

fs::path place_of_runs() {
  std::error_code failed;
  fs::path place = fs::temp_directory_path(failed);
  if (!failed) return place;
  const char* named = std::getenv("TMPDIR");
  throw support::UsageError(
      fmt::format("TMPDIR is '{}', which is no folder (one that is there and can be written)", named ? named : "/tmp"));
}

std::unique_lock<std::mutex> remove_run_folders() {
  std::unique_lock lock(temporary().mutex);
  for (const fs::path& folder : temporary().folders) remove_surely(folder);
  return lock;
}

}  // namespace mpmvv::codes
