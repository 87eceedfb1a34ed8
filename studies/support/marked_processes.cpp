#include "studies/support/marked_processes.hpp"

#include <unistd.h>

#include <charconv>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace mpmvv::support {

namespace fs = std::filesystem;

namespace {

/// The process whose folder in /proc has this name; 0 for all other names.
pid_t process_of(const std::string& name) {
  pid_t process = 0;
  const auto [end, failed] = std::from_chars(name.data(), name.data() + name.size(), process);
  return failed == std::errc() && end == name.data() + name.size() ? process : 0;
}

/// The process's environment, each entry with a zero byte before and behind it; only one zero byte where it may not be
/// read.
std::string environment_of(const fs::path& folder) {
  std::ifstream in(folder / "environ", std::ios::binary);
  return std::string(1, '\0').append(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

/// The processes, except this one, whose environment contains `wanted`.
std::vector<pid_t> marked(const std::string& wanted) {
  std::vector<pid_t> found;
  std::error_code absent;
  for (fs::directory_iterator at("/proc", absent), end; !absent && at != end; at.increment(absent)) {
    const pid_t process = process_of(at->path().filename());
    if (process > 0 && process != getpid() && environment_of(at->path()).find(wanted) != std::string::npos)
      found.push_back(process);
  }
  return found;
}

}  // namespace

void kill_marked(const std::string& variable, const std::string& value) {
  constexpr int passes = 10;
  std::string wanted = std::string(1, '\0') + variable + "=" + value;
  if (!value.empty()) wanted += '\0';
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<pid_t> found = marked(wanted);
    if (found.empty()) return;
    for (const pid_t process : found) kill(process, SIGKILL);
  }
}

}  // namespace mpmvv::support
