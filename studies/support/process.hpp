#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mpmvv::support {

/// How a child process ended.
struct ProcessEnd {
  int start_error = 0;     ///< errno when it could not be started, else 0
  bool timed_out = false;  ///< it was killed at the time limit
  int signal = 0;          ///< that ended it, else 0
  int exit_code = 0;       ///< 128 + signal when a signal ended it
  std::string output;      ///< its standard output and standard error; of more than 16 MiB the first and the last 8 MiB

  bool good() const { return start_error == 0 && !timed_out && exit_code == 0; }
};

/// Runs a program found on PATH in a folder, with standard input empty and some environment variables set, and waits
/// for it until the time limit. Then its whole process group is killed, also what is left of it when it has ended
/// before. Of the caller's own variables it sees those that are kept; all when none are named.
ProcessEnd run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                       const std::map<std::string, std::string>& environment, std::chrono::milliseconds limit,
                       const std::optional<std::set<std::string>>& kept = std::nullopt);

/// Kills all that `run_process` has started, on whatever thread, and lets it start no more: the caller is about to end.
void kill_processes();

}  // namespace mpmvv::support
