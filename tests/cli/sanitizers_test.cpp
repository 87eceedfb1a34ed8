#include <fnmatch.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "program.hpp"

namespace mpmvv::cli {
namespace sanitizers_test {

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

std::vector<std::string> cases_of_all_programs() {
  std::vector<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(program()).parent_path())) {
    if (!entry.path().filename().string().starts_with("test_")) continue;
    const std::vector<std::string> cases = cases_of(entry.path().string());
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

/// Patterns that name none of the cases.
std::vector<std::string> without_a_case(const std::string& file, const std::vector<std::string>& cases) {
  std::vector<std::string> lost;
  for (const std::string& line : lines_of(read_text(std::string(MPMVV_SOURCE_DIR "/tests/") + file))) {
    const std::string pattern = line.substr(line[0] == '-' ? 1 : 0);
    const auto named = [&](const std::string& name) { return fnmatch(pattern.c_str(), name.c_str(), 0) == 0; };
    if (std::ranges::none_of(cases, named)) lost.push_back(pattern);
  }
  return lost;
}

TEST(Sanitizers, RunAndLeaveOutCasesThatAreThere) {
  const std::vector<std::string> cases = cases_of_all_programs();
  EXPECT_THAT(without_a_case("sanitized_memory.txt", cases), IsEmpty());
  EXPECT_THAT(without_a_case("sanitized_threads.txt", cases), IsEmpty());
}

}  // namespace sanitizers_test
}  // namespace mpmvv::cli
