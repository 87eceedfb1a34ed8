#include "studies/support/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <string_view>
#include <thread>

#include "studies/support/kept_output.hpp"

namespace mpmvv::support {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_half = 8 << 20;  ///< bytes

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (auto& t : texts) result.push_back(t.data());
  result.push_back(nullptr);
  return result;
}

using Kept = std::optional<std::set<std::string>>;

std::vector<std::string> environment_with(const std::map<std::string, std::string>& changes, const Kept& kept) {
  std::vector<std::string> result;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string name(text.substr(0, text.find('=')));
    if (!changes.contains(name) && (!kept || kept->contains(name))) result.emplace_back(text);
  }
  for (const auto& [name, value] : changes) result.push_back(name + "=" + value);
  return result;
}

/// Starts the child with standard output and standard error on `out`; returns 0 or an errno.
int spawn(pid_t& child, std::vector<std::string> command, const std::filesystem::path& folder,
          std::vector<std::string> variables, int out) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  sigset_t none;  // a child that inherits blocked signals cannot be asked to end
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);

  const int failed = posix_spawnp(&child, command.front().c_str(), &actions, &attributes, pointers(command).data(),
                                  pointers(variables).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failed;
}

/// Whether the child has ended. It stays a zombie until waitpid, so that no other process gets its number before its
/// group is killed.
bool has_ended(pid_t child) {
  siginfo_t seen{};
  return waitid(P_PID, static_cast<id_t>(child), &seen, WEXITED | WNOHANG | WNOWAIT) == 0 && seen.si_pid == child;
}

/// Appends what can be read within `wait`; false at the end of the output or on an error.
bool read_some(int in, KeptOutput& output, std::chrono::milliseconds wait) {
  pollfd ready{in, POLLIN, 0};
  if (poll(&ready, 1, static_cast<int>(wait.count())) <= 0) return true;
  static thread_local std::array<char, 1 << 16> buffer;
  const ssize_t n = read(in, buffer.data(), buffer.size());
  if (n > 0) output.append({buffer.data(), static_cast<std::size_t>(n)});
  return n > 0 || (n < 0 && errno == EINTR);
}

/// Reads until the child has ended, the deadline comes or `stop` asks for it, and returns which it was. Does not wait
/// for what the child's own children write later.
enum class Reached { end, deadline, stop };
Reached read_until_end(pid_t child, int in, KeptOutput& output, Clock::time_point deadline,
                       const std::stop_token& stop) {
  constexpr std::chrono::milliseconds look{10}, short_look{1};
  bool is_open = true;
  while (!has_ended(child)) {
    if (Clock::now() >= deadline) return Reached::deadline;
    if (stop.stop_requested()) return Reached::stop;
    if (is_open)
      is_open = read_some(in, output, look);
    else
      std::this_thread::sleep_for(short_look);
  }
  if (is_open) read_some(in, output, {});  // one read takes all that a pipe holds, 64 KiB
  return Reached::end;
}

/// The process groups that are running, for kill_processes.
class Running {
 public:
  /// Starts a group, with nobody killing all in between; returns 0 or an errno.
  template <class Start>
  int add(pid_t& group, const Start& start) {
    const std::lock_guard lock(mutex_);
    const int failed = start();
    if (failed != 0) return failed;
    groups_.insert(group);
    if (is_over_) kill(-group, SIGKILL);
    return 0;
  }
  void remove(pid_t group) {
    const std::lock_guard lock(mutex_);
    groups_.erase(group);
  }
  std::unique_lock<std::mutex> kill_all() {
    std::unique_lock lock(mutex_);
    is_over_ = true;
    for (const pid_t group : groups_) kill(-group, SIGKILL);
    return lock;
  }

 private:
  std::mutex mutex_;
  std::set<pid_t> groups_;
  bool is_over_ = false;
};

Running& running() {
  static Running all;
  return all;
}

}  // namespace

std::unique_lock<std::mutex> kill_processes() {
  return running().kill_all();
}

ProcessEnd run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                       const std::map<std::string, std::string>& environment, std::chrono::milliseconds limit,
                       const Kept& kept, const std::stop_token& stop) {
  const auto deadline = Clock::now() + limit;
  ProcessEnd end;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    end.start_error = errno;
    return end;
  }
  pid_t child = 0;
  end.start_error =
      running().add(child, [&] { return spawn(child, command, folder, environment_with(environment, kept), ends[1]); });
  close(ends[1]);
  if (end.start_error == 0) {
    KeptOutput output(kept_half);
    const Reached reached = read_until_end(child, ends[0], output, deadline, stop);
    end.timed_out = reached == Reached::deadline;
    end.stopped = reached == Reached::stop;
    end.output = output.text();
    kill(-child, SIGKILL);  // the whole group: also what the child has left behind
    running().remove(child);
    int status = 0;
    waitpid(child, &status, 0);
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.exit_code = end.signal == 0 ? WEXITSTATUS(status) : 128 + end.signal;
  }
  close(ends[0]);
  return end;
}

}  // namespace mpmvv::support
