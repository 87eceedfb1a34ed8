#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace mpmvv {
namespace layers_test {

namespace fs = std::filesystem;

struct Include {
  std::string file, target;
};

/// Every #include of the folder's sources, files relative to the top of the tree.
std::vector<Include> includes_of(const std::string& folder) {
  static const std::regex pattern(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  const fs::path top = MPMVV_SOURCE_DIR;
  std::vector<Include> all;
  for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
    if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
    std::ifstream in(entry.path());
    std::smatch match;
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line, match, pattern)) all.push_back({fs::relative(entry.path(), top).string(), match[1]});
  }
  return all;
}

std::string folder_of(const std::string& path) {
  return path.substr(0, path.find('/'));
}

/// The layers of the house: a folder may include itself and those named here.
TEST(Layers, EachFolderIncludesOnlyWhatItMay) {
  const std::map<std::string, std::set<std::string>> may{{"mms", {}},
                                                         {"solver", {}},
                                                         {"studies", {"mms", "solver"}},
                                                         {"goldens", {"studies"}},
                                                         {"reports", {"studies"}},
                                                         {"cli", {"studies", "goldens", "reports"}}};
  for (const auto& [folder, others] : may) {
    const auto includes = includes_of(folder);
    EXPECT_FALSE(includes.empty()) << folder;
    for (const Include& include : includes) {
      const std::string target = folder_of(include.target);
      EXPECT_NE(target, "tests") << include.file << " includes " << include.target;
      if (!may.contains(target) || target == folder) continue;
      EXPECT_TRUE(others.contains(target)) << include.file << " includes " << include.target;
    }
  }
}

/// goldens and reports see the nouns of studies, never what ties them to solver and mms.
TEST(Layers, RecordsAreFreeOfSolverAndSolutions) {
  std::set<std::string> tied;
  for (const Include& include : includes_of("studies"))
    if (folder_of(include.target) == "solver" || folder_of(include.target) == "mms") tied.insert(include.file);
  ASSERT_TRUE(tied.contains("studies/problems/problem.hpp"));
  for (const std::string folder : {"goldens", "reports"})
    for (const Include& include : includes_of(folder)) EXPECT_FALSE(tied.contains(include.target)) << include.file;
}

/// What users name is made printable there.
TEST(Layers, OneFileWritesToTheTerminal) {
  const std::regex prints("fmt::print|std::cout|std::cerr|puts\\(|printf\\(|fwrite\\(");
  std::set<std::string> places;
  for (const std::string folder : {"studies", "goldens", "reports", "cli"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MPMVV_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);)
        if (std::regex_search(line, prints)) places.insert(folder + "/" + entry.path().filename().string());
    }
  EXPECT_EQ(places, std::set<std::string>{"cli/console.cpp"});
}

TEST(Layers, EachLibraryIsNamedInOnePlace) {
  std::map<std::string, std::set<std::string>> places;
  for (const std::string folder : {"mms", "solver", "studies", "goldens", "reports", "cli"})
    for (const Include& include : includes_of(folder))
      for (const char* library : {"sqlite3.h", "gnuplot-iostream.h", "toml++"})
        if (include.target.starts_with(library)) places[library].insert(include.file);
  EXPECT_EQ(places["sqlite3.h"].size(), 1U);
  EXPECT_EQ(places["gnuplot-iostream.h"].size(), 1U);
  EXPECT_EQ(places["toml++"].size(), 1U);
}

}  // namespace layers_test
}  // namespace mpmvv
