#include "studies/support/memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace mpmvv::support {

namespace fs = std::filesystem;

namespace {

/// The file's number; none where there is no such file, or a word ("max").
std::optional<double> number_in(const fs::path& file) {
  std::ifstream in(file);
  double number = 0;
  return in >> number ? std::optional(number) : std::nullopt;
}

double of_the_system(const fs::path& root) {
  std::ifstream in(root / "proc/meminfo");
  double kilobytes = 0;
  for (std::string word; in >> word;)
    if (word == "MemAvailable:" && in >> kilobytes) return 1024 * kilobytes;
  return std::numeric_limits<double>::infinity();
}

}  // namespace

double available_memory(const fs::path& root) {
  const auto limit = number_in(root / "sys/fs/cgroup/memory.max");
  const double system = of_the_system(root);
  if (!limit) return system;
  return std::min(system, std::max(0.0, *limit - number_in(root / "sys/fs/cgroup/memory.current").value_or(0)));
}

}  // namespace mpmvv::support
