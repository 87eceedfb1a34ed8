#pragma once
#include <filesystem>
#include <mutex>

namespace mpmvv::codes {

/// The folder of a run: the named one, or a temporary one, which the destructor removes unless it is kept.
class RunFolder {
 public:
  /// Makes the folder. Throws UsageError if the named one holds anything: it would be taken for output of this run.
  explicit RunFolder(const std::filesystem::path& named);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Keeps the folder and returns its path. A temporary one is renamed to `mpmvv-failed-...`.
  std::filesystem::path keep();

 private:
  std::filesystem::path path_;
  bool is_temporary_;
};

/// Returns the folder for temporary files, which `TMPDIR` names. Throws UsageError if that is no folder.
std::filesystem::path place_of_runs();

/// Removes the temporary folders of this process, which is about to end. Threads that want to make another one, or to
/// keep theirs, wait as long as the lock is held.
[[nodiscard]] std::unique_lock<std::mutex> remove_run_folders();

}  // namespace mpmvv::codes
