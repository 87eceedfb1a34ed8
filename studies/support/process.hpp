#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

namespace mpmvv::support {

/// How a child process ended.
struct ProcessEnd {
  int start_error = 0;     ///< errno when it could not be started, else 0
  bool timed_out = false;  ///< it was killed at the time limit
  bool stopped = false;    ///< it was killed because the caller asked for it
  int signal = 0;          ///< the signal that ended it, else 0
  int exit_code = 0;       ///< 128 + signal when a signal ended it
  std::string output;      ///< its standard output and standard error; of more than 16 MiB the first and the last 8 MiB

  bool good() const { return start_error == 0 && !timed_out && !stopped && exit_code == 0; }
};

/// Runs a program found on PATH in a folder, with empty standard input and the variables of `environment` set, until it
/// ends, the time limit is reached or `stop` asks for it. In each case its whole process group is killed then, so that
/// it leaves nothing behind. Of the caller's own variables the program sees those that `kept` names; all without
/// `kept`.
ProcessEnd run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                       const std::map<std::string, std::string>& environment, std::chrono::milliseconds limit,
                       const std::optional<std::set<std::string>>& kept = std::nullopt,
                       const std::stop_token& stop = {});

/// Kills all that `run_process` has started on any thread, and at once whatever it starts later: for a caller that is
/// about to end. No call of `run_process` returns as long as the lock is held.
std::unique_lock<std::mutex> kill_processes();

}  // namespace mpmvv::support
