#include "studies/codes/run_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <system_error>

#include "studies/support/file.hpp"

namespace mpmvv::codes {

namespace fs = std::filesystem;

namespace {

/// Of this process; in it a folder for each run.
fs::path all_runs() {
  return fs::temp_directory_path() / fmt::format("mpmvv-runs-{}", getpid());
}

fs::path next_of(const char* what) {
  static std::atomic<int> count = 0;
  return all_runs().string() + (*what == '\0' ? "" : fmt::format("-{}", what)) + fmt::format("/{}", ++count);
}

}  // namespace

RunFolder::RunFolder(const fs::path& named)
    : path_(named.empty() ? next_of("") : fs::absolute(named)), is_temporary_(named.empty()) {
  support::make_folder(path_);
}

RunFolder::~RunFolder() {
  std::error_code ignored;
  if (!is_temporary_) return;
  fs::remove_all(path_, ignored);
  fs::remove(path_.parent_path(), ignored);  // the last one's
}

fs::path RunFolder::keep() {
  if (!is_temporary_) return path_;
  const fs::path place = next_of("failed");
  support::make_folder(place.parent_path());
  support::move_file(path_, place);
  path_ = place;
  is_temporary_ = false;
  return place;
}

void remove_run_folders() {
  std::error_code ignored;
  fs::remove_all(all_runs(), ignored);
}

}  // namespace mpmvv::codes
