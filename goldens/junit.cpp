#include "goldens/junit.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>

#include "studies/support/printable.hpp"

namespace mpmvv::goldens {

namespace {

/// U+FFFE and U+FFFF, which XML forbids; the other forbidden characters are escaped by printable().
bool is_forbidden(std::string_view character) {
  return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
}

/// The text as XML holds it, in attributes as well as in content.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : support::printable(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
    if (out.size() >= 3 && is_forbidden(std::string_view(out).substr(out.size() - 3)))
      out.replace(out.size() - 3, 3, "?");
  }
  return out;
}

std::string test_case(const GateResult& result) {
  const std::string head =
      fmt::format(R"(    <testcase classname="{}" name="{}" time="0")", escaped(result.study), escaped(result.name));
  const std::string reason = escaped(result.reason);
  switch (result.verdict) {
    case Verdict::pass:
      return head + "/>\n";
    case Verdict::fail:
      return fmt::format(
          "{}>\n      <failure type=\"regression\" message=\"{}\">expected {}{}</failure>\n    </testcase>\n", head,
          reason, escaped(result.expected), escaped(measured_text(result)));
    case Verdict::inconclusive:
      break;
  }
  return fmt::format("{}>\n      <skipped message=\"inconclusive: {}\"/>\n    </testcase>\n", head, reason);
}

std::string test_suite(const std::string& study, const GateReport& report) {
  std::string cases;
  for (const GateResult& result : report.results) cases += test_case(result);
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" time=\"0\">\n{}  "
      "</testsuite>\n",
      escaped(study), report.results.size(), report.count(Verdict::fail), report.count(Verdict::inconclusive), cases);
}

}  // namespace

std::string junit_xml(const GateReport& report) {
  std::map<std::string, GateReport> by_study;
  for (const GateResult& result : report.results) by_study[result.study].results.push_back(result);
  std::string suites;
  for (const auto& [study, part] : by_study) suites += test_suite(study, part);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"mpmvv gate\" tests=\"{}\" failures=\"{}\" errors=\"0\" time=\"0\">\n{}</testsuites>\n",
      report.results.size(), report.count(Verdict::fail), suites);
}

}  // namespace mpmvv::goldens
