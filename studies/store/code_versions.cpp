#include "studies/store/code_versions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace mpmvv::store {

namespace {

struct CodeLine {
  std::string code, version, digest;
};

/// Of all studies of a store, each once.
std::vector<CodeLine> lines_in(const Database& database) {
  std::set<std::string> texts;
  database.each("SELECT DISTINCT codes FROM studies WHERE codes IS NOT NULL", {}, [&](const Row& row) {
    std::istringstream lines(row["codes"].text());
    for (std::string line; std::getline(lines, line);) texts.insert(line);
  });
  std::vector<CodeLine> lines;
  for (const std::string& text : texts) {
    CodeLine line;
    std::istringstream(text) >> line.code >> line.version >> line.digest;
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string time_of_first_run(const Database& database, const CodeLine& line) {
  return database
      .scalar("SELECT min(kept_at) FROM runs WHERE instr(case_text, ?)",
              {fmt::format(" code_version={} adapter={} ", line.version, line.digest)})
      .to_string();
}

}  // namespace

std::string code_lines(std::span<const std::vector<cases::Case>> cases) {
  std::set<std::string> lines;
  for (const std::vector<cases::Case>& of_series : cases)
    for (const cases::Case& c : of_series)
      if (!c.scheme.code.empty())
        lines.insert(code_line(c.scheme.code, {c.scheme.adapter, {c.scheme.code_version}, ""}));
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string code_line(const std::string& code, const Version& version) {
  return fmt::format("{} {} {}", code, version.commits.front(), version.digest);
}

std::vector<std::string> codes_in(const Database& database) {
  std::set<std::string> codes;
  for (const CodeLine& line : lines_in(database)) codes.insert(line.code);
  return {codes.begin(), codes.end()};
}

std::vector<Version> versions_of_code(const Database& database, const std::string& code) {
  std::vector<Version> versions;
  for (const CodeLine& line : lines_in(database))
    if (line.code == code) versions.push_back({line.digest, {line.version}, time_of_first_run(database, line)});
  std::ranges::stable_sort(versions, {}, &Version::time);
  return versions;
}

}  // namespace mpmvv::store
