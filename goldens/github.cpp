#include "goldens/github.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "studies/support/printable.hpp"

namespace mpmvv::goldens {

namespace {

/// Escapes what would end a command's message (in a property: the property), and the control characters that a log
/// would obey.
std::string percent_escaped(const std::string& text, bool property) {
  std::string out;
  for (const char c : support::printable(text)) {
    const bool special = c == '%' || (property && (c == ':' || c == ','));
    out += special ? fmt::format("%{:02X}", static_cast<int>(c)) : std::string(1, c);
  }
  return out;
}

std::string annotation(const char* command, const GateResult& result) {
  const auto colon = result.where.rfind(':');
  const std::string message = fmt::format("expected {}{} ({})", result.expected, measured_text(result), result.reason);
  return fmt::format("::{} file={},line={},title={}::{}\n", command,
                     percent_escaped(result.where.substr(0, colon), true), result.where.substr(colon + 1),
                     percent_escaped(result.study + ": " + result.name, true), percent_escaped(message, false));
}

/// One notice for all studies that the store has nothing of; it marks no file.
std::string notice_of_absent(const GateReport& report) {
  std::set<std::string> studies;
  for (const GateResult& result : report.results)
    if (result.is_absent) studies.insert(result.study);
  if (studies.empty()) return "";
  const auto goldens = std::ranges::count(report.results, true, &GateResult::is_absent);
  return fmt::format("::notice title=goldens without a result::{} of {}: the store has nothing of {}\n", goldens,
                     report.results.size(),
                     studies.size() == 1 ? "their study" : fmt::format("their {} studies", studies.size()));
}

}  // namespace

std::string github_annotations(const GateReport& report) {
  std::string lines;
  for (const GateResult& result : report.results) {
    if (result.is_absent) continue;
    if (result.verdict == Verdict::fail) lines += annotation("error", result);
    if (result.verdict == Verdict::inconclusive) lines += annotation("warning", result);
  }
  return lines + notice_of_absent(report);
}

}  // namespace mpmvv::goldens
