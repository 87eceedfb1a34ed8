#include "studies/store/code_versions.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <utility>

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

/// Time and number.
std::pair<std::string, std::int64_t> first_run(const Database& database, const CodeLine& line) {
  std::pair<std::string, std::int64_t> first;
  database.each("SELECT kept_at, id FROM runs WHERE instr(case_text, ?) ORDER BY kept_at, id LIMIT 1",
                {fmt::format(" code_version={} adapter={} ", line.version, line.digest)}, [&](const Row& row) {
                  first = {row["kept_at"].text(), row["id"].integer()};
                });
  return first;
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
  std::multimap<std::pair<std::string, std::int64_t>, Version> by_first_run;
  for (const CodeLine& line : lines_in(database))
    if (line.code == code) {
      const auto first = first_run(database, line);
      by_first_run.emplace(first, Version{line.digest, {line.version}, first.first});
    }
  std::vector<Version> versions;
  for (auto& [first, version] : by_first_run) versions.push_back(std::move(version));
  return versions;
}

}  // namespace mpmvv::store
