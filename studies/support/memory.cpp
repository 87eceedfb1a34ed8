#include "studies/support/memory.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace mpmvv::support {

namespace fs = std::filesystem;

namespace {

/// The number that stands behind this word in a file; of the file's first word if that is a number and `word` empty.
std::optional<double> number_in(const fs::path& file, const std::string& word = "") {
  std::ifstream in(file);
  double number = 0;
  for (std::string found; !word.empty() && found != word;)
    if (!(in >> found)) return std::nullopt;
  return in >> number ? std::optional(number) : std::nullopt;
}

double of_the_system(const fs::path& root) {
  if (const auto kilobytes = number_in(root / "proc/meminfo", "MemAvailable:")) return 1024 * *kilobytes;
  return static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// The path of the program's control group, whose line in /proc is "0::/its/path", without the slash in front.
fs::path control_group(const fs::path& root) {
  std::ifstream in(root / "proc/self/cgroup");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("0::/")) return line.substr(4);
  return {};
}

/// What a control group leaves of its limit; infinity where it has none. What the system reads files into counts as
/// used, but it is given back where a program asks for memory.
double left_in(const fs::path& group) {
  const auto limit = number_in(group / "memory.max");
  if (!limit) return std::numeric_limits<double>::infinity();
  return *limit - (number_in(group / "memory.current").value_or(0) -
                   number_in(group / "memory.stat", "inactive_file").value_or(0));
}

}  // namespace

double available_memory(const fs::path& root) {
  fs::path group = root / "sys/fs/cgroup";
  double left = std::min(of_the_system(root), left_in(group));
  for (const fs::path& inner : control_group(root)) left = std::min(left, left_in(group /= inner));
  return std::max(0.0, left);
}

}  // namespace mpmvv::support
