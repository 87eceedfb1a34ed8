#include "tests/mutation/program_gate.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>

namespace mpmvv::mutation {

namespace fs = std::filesystem;

std::vector<std::string> program_parts() {
  return {".github",
          "CHANGELOG.md",
          "CMakeLists.txt",
          "CMakePresets.json",
          "CONTRIBUTING.md",
          "README.md",
          "adapters",
          "cli",
          "cmake",
          "docs",
          "goldens",
          "mms",
          "reports",
          "run",
          "solver",
          "studies",
          "tests"};
}

std::string gate_version(const ScratchTree& tree) {
  const auto lies_in = [](const std::string& file, const auto& parts) {
    return std::ranges::any_of(parts, [&](const char* part) { return is_within(file, part); });
  };
  const auto decides = [&](const std::string& file) {
    return !lies_in(file, std::array{".github", "CHANGELOG.md", "CONTRIBUTING.md", "README.md", "adapters", "cli",
                                     "docs", "run", "tests/benchmark", "tests/mutation"});
  };
  const auto expects = [&](const std::string& file) {
    const bool is_list = file.ends_with(".txt") && !file.ends_with("CMakeLists.txt");
    return lies_in(file, std::array{"reports", "tests"}) || file.ends_with(".toml") || is_list;
  };
  const auto digest = [&](bool expecting) {
    return tree.digest([&](const std::string& file) { return decides(file) && expects(file) == expecting; });
  };
  return digest(false) + "/" + digest(true);
}

std::vector<std::string> listed_studies(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    if (std::string name; words >> name) names.push_back(fs::path(name).stem().string());
  }
  return names;
}

std::vector<std::string> studies_with_goldens(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const fs::path file : files)
    if (file.parent_path() == "goldens" && file.extension() == ".toml") names.push_back(file.stem().string());
  return names;
}

bool decides_the_gate(const std::string& file) {
  return !is_within(file, "reports") && !is_within(file, "mms/c") && !is_within(file, "studies/codes");
}

std::vector<std::string> test_programs(const std::string& file) {
  if (file.starts_with("mms/c/")) return {"test_c_interface"};
  if (file.starts_with("mms/")) return {"test_mms", "test_solver", "test_studies", "test_cli"};
  if (file.starts_with("solver/")) return {"test_solver", "test_studies", "test_cli"};
  if (file.starts_with("reports/")) return {"test_reports", "test_cli"};
  std::vector<std::string> all{"test_studies", "test_goldens", "test_reports",    "test_cli",
                               "test_mms",     "test_solver",  "test_c_interface"};
  const std::string own = "test_" + file.substr(0, file.find('/'));
  std::ranges::stable_partition(all, [&](const std::string& program) { return program == own; });
  return all;
}

}  // namespace mpmvv::mutation
