#include "cli/submit_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>
#include <deque>
#include <sstream>

namespace mpmvv::cli {

namespace {

/// The last lines that are not empty, in one: an error may stand behind warnings, or before what follows from it.
std::string last_lines(const std::string& output) {
  constexpr std::size_t most = 5;
  std::deque<std::string> lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    lines.push_back(line);
    if (lines.size() > most) lines.pop_front();
  }
  return lines.empty() ? "it printed nothing" : fmt::format("{}", fmt::join(lines, "; "));
}

}  // namespace

std::string submit_fault(const std::filesystem::path& script, const support::ProcessEnd& end,
                         std::chrono::minutes limit, const std::string& queued) {
  const std::string file = script.string();
  if (end.start_error != 0)
    return fmt::format("'{}' could not be started: {} (a --folder from which programs can be started)", file,
                       std::strerror(end.start_error));
  const std::string printed = last_lines(end.output);
  if (end.timed_out)
    return fmt::format("'{}' gave no answer for {} minutes and was ended: {} ({})", file, limit.count(), printed,
                       queued);
  if (end.stopped) return fmt::format("'{}' was ended before it had finished: {} ({})", file, printed, queued);
  return fmt::format("'{}' ended with {}: {} (--dry-run only writes it)", file, end.exit_code, printed);
}

}  // namespace mpmvv::cli
