#pragma once
#include <filesystem>
#include <mutex>

namespace mpmvv::codes {

/// The folder of a run: one named, or a temporary one, which goes unless it is kept.
class RunFolder {
 public:
  explicit RunFolder(const std::filesystem::path& named);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Gives it a place among those that have failed, and returns that.
  std::filesystem::path keep();

 private:
  std::filesystem::path path_;
  bool is_temporary_;
};

/// Where the environment says that temporary files belong (`TMPDIR`). UsageError where that is no folder.
std::filesystem::path place_of_runs();

/// Removes the temporary folders of this process, which is about to end. As long as the lock is held, threads that
/// would make another one, or keep theirs, wait.
[[nodiscard]] std::unique_lock<std::mutex> remove_run_folders();

}  // namespace mpmvv::codes
