#include <fnmatch.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "program.hpp"

namespace mpmvv::cli::sanitizers_test {

using ::testing::IsEmpty;

/// Lines of a text that say something: no comment, not empty.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != '#') lines.push_back(line);
  return lines;
}

/// Full names of a test program's cases: it lists a suite, and below it, set in by two, its cases.
std::vector<std::string> cases_of(const std::string& test_program) {
  std::vector<std::string> cases;
  std::string suite;
  for (std::string line : lines_of(shell("'" + test_program + "' --gtest_list_tests").out)) {
    line = line.substr(0, line.find("  #"));
    if (line.starts_with("  "))
      cases.push_back(suite + line.substr(2));
    else
      suite = line;
  }
  return cases;
}

/// Patterns of a file that name none of the cases.
std::vector<std::string> without_a_case(const std::string& file, const std::vector<std::string>& cases) {
  std::vector<std::string> lost;
  const std::vector<std::string> lines = lines_of(read_text(std::string(MPMVV_SOURCE_DIR "/tests/") + file));
  EXPECT_FALSE(lines.empty()) << file;
  for (const std::string& line : lines) {
    const std::string pattern = line.substr(line[0] == '-' ? 1 : 0);
    const auto named = [&](const std::string& name) { return fnmatch(pattern.c_str(), name.c_str(), 0) == 0; };
    if (std::ranges::none_of(cases, named)) lost.push_back(pattern);
  }
  return lost;
}

TEST(Sanitizers, RunAndLeaveOutCasesThatAreThere) {
  std::vector<std::string> cases;
  for (const char* name : {"test_cli", "test_goldens", "test_mms", "test_reports", "test_solver", "test_studies"}) {
    const std::filesystem::path test_program = std::filesystem::path(program()).replace_filename(name);
    if (!std::filesystem::exists(test_program)) GTEST_SKIP() << name << " is not built";
    const std::vector<std::string> more = cases_of(test_program);
    cases.insert(cases.end(), more.begin(), more.end());
  }
  for (const char* file : {"sanitized_memory.txt", "sanitized_leaks.txt", "sanitized_threads.txt"})
    EXPECT_THAT(without_a_case(file, cases), IsEmpty());
}

}  // namespace mpmvv::cli::sanitizers_test
