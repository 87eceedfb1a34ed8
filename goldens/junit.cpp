#include "goldens/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

namespace mpmvv {

namespace {

/// For attributes and text alike. XML 1.0 has no way to write most control characters.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
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
      case '\n':
      case '\r':
      case '\t':
        out += fmt::format("&#{};", static_cast<int>(c));
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
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
          "{}>\n      <failure type=\"regression\" message=\"{}\">expected {}, measured {}</failure>\n    "
          "</testcase>\n",
          head, reason, escaped(result.expected), escaped(result.measured));
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

}  // namespace mpmvv
