#include "studies/store/code_versions.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "studies/store/trial.hpp"

namespace mpmvv::store {

namespace {

struct CodeLine {
  std::string code;
  Version version;
};

std::vector<CodeLine> lines_of(const std::string& text) {
  std::vector<CodeLine> lines;
  std::istringstream words(text);
  for (CodeLine line; words >> line.code >> line.version.commits.emplace_back() >> line.version.digest; line = {})
    lines.push_back(line);
  return lines;
}

/// Calls visit(line) for each code's line of all studies that are no trials, in the order in which the studies were
/// kept. The version's time is when its study was kept.
template <class Visit>
void each_line(const Database& database, const Visit& visit) {
  database.each("SELECT codes, kept_at, text FROM studies WHERE codes IS NOT NULL ORDER BY kept_at, id", {},
                [&](const Row& row) {
                  if (!trial_of(row["text"].text()).empty()) return;
                  for (CodeLine& line : lines_of(row["codes"].text())) {
                    line.version.time = row["kept_at"].text();
                    visit(line);
                  }
                });
}

}  // namespace

std::string code_lines(const std::vector<records::Series>& series) {
  std::set<std::string> lines;
  for (const records::Series& s : series)
    if (s.code && !s.code->digest.empty())
      lines.insert(code_line(s.code->name, {s.code->digest, {s.code->version}, ""}));
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string digest_in(const std::string& lines, const records::OtherCode& code) {
  for (const CodeLine& line : lines_of(lines))
    if (line.code == code.name && line.version.commits.front() == code.version) return line.version.digest;
  return "";
}

std::string code_line(const std::string& code, const Version& version) {
  return fmt::format("{} {} {}", code, version.commits.front(), version.digest);
}

std::vector<std::string> codes_in(const Database& database) {
  std::set<std::string> codes;
  each_line(database, [&](const CodeLine& line) { codes.insert(line.code); });
  return {codes.begin(), codes.end()};
}

std::vector<Version> versions_of_code(const Database& database, const std::string& code) {
  std::vector<Version> versions;
  each_line(database, [&](const CodeLine& line) {
    if (line.code != code) return;
    const auto is_same = [&](const Version& v) {
      return v.digest == line.version.digest && v.commits == line.version.commits;
    };
    std::erase_if(versions, is_same);
    versions.push_back(line.version);
  });
  return versions;
}

}  // namespace mpmvv::store
