#include "goldens/github.hpp"

#include <fmt/format.h>

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
  const std::string message =
      fmt::format("expected {}, measured {} ({})", result.expected, result.measured, result.reason);
  return fmt::format("::{} file={},line={},title={}::{}\n", command,
                     percent_escaped(result.where.substr(0, colon), true), result.where.substr(colon + 1),
                     percent_escaped(result.study + ": " + result.name, true), percent_escaped(message, false));
}

}  // namespace

std::string github_annotations(const GateReport& report) {
  std::string lines;
  for (const GateResult& result : report.results) {
    if (result.verdict == Verdict::fail) lines += annotation("error", result);
    if (result.verdict == Verdict::inconclusive) lines += annotation("warning", result);
  }
  return lines;
}

}  // namespace mpmvv::goldens
