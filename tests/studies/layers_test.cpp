#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace mpmvv::layers_test {

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

/// `solver/basis/gimp.hpp` -> `solver`, `studies/fits/window.hpp` -> `studies/fits`.
std::string room_of(const std::string& path) {
  const std::size_t first = path.find('/'), second = path.find('/', first + 1);
  const bool is_room = path.starts_with("studies/") && second != std::string::npos;
  return path.substr(0, is_room ? second : first);
}

using Rooms = std::set<std::string>;

/// A room may include itself, those named here, and what these may include.
const std::map<std::string, Rooms> may_include{
    {"mms", {}},
    {"solver", {}},
    {"studies/support", {}},
    {"studies/fits", {"studies/support"}},
    {"studies/cases", {"studies/support"}},
    {"studies/records", {"studies/cases", "studies/fits"}},
    {"studies/claims", {"studies/records"}},
    {"studies/store", {"studies/records"}},
    {"studies/problems", {"studies/cases", "mms", "solver"}},
    {"studies/settings", {"studies/problems"}},
    {"studies/runs", {"studies/settings", "studies/records"}},
    {"studies/checks", {"studies/runs"}},
    {"studies/codes", {"studies/runs"}},
    {"studies/plan", {"studies/checks", "studies/codes", "studies/claims", "studies/store"}},
    {"goldens", {"studies/claims", "studies/store"}},
    {"reports", {"studies/claims", "studies/store"}},
    {"cli", {"goldens", "reports", "studies/plan"}},
};

/// Adds all that a room may include, and what these may.
void reach(const std::string& room, Rooms& reached) {
  for (const std::string& next : may_include.at(room))
    if (reached.insert(next).second) reach(next, reached);
}

Rooms reach_of(const std::string& room) {
  Rooms reached;
  reach(room, reached);
  EXPECT_FALSE(reached.contains(room)) << room << " may include itself by way of others";
  reached.insert(room);
  return reached;
}

using Includes = std::map<std::string, std::set<std::string>>;

/// Every source with the headers of ours that it includes.
const Includes& includes() {
  static const Includes all = [] {
    Includes found;
    for (const std::string folder : {"mms", "solver", "studies", "goldens", "reports", "cli"})
      for (const Include& include : includes_of(folder)) {
        auto& targets = found[include.file];
        if (fs::exists(fs::path(MPMVV_SOURCE_DIR) / include.target)) targets.insert(include.target);
      }
    return found;
  }();
  return all;
}

/// The rooms that a source sees through its includes and theirs, to their end.
void follow(const std::string& file, std::set<std::string>& seen) {
  if (!seen.insert(file).second) return;
  if (const auto found = includes().find(file); found != includes().end())
    for (const std::string& target : found->second) follow(target, seen);
}

/// `folder` is a room or a folder in one.
Rooms rooms_seen_from(const std::string& folder) {
  std::set<std::string> seen;
  for (const auto& [file, targets] : includes())
    if (file.starts_with(folder + '/')) follow(file, seen);
  Rooms rooms;
  for (const std::string& file : seen) rooms.insert(room_of(file));
  return rooms;
}

TEST(Layers, EachFolderIncludesOnlyWhatItMay) {
  Rooms rooms;
  for (const auto& [file, targets] : includes()) {
    rooms.insert(room_of(file));
    ASSERT_TRUE(may_include.contains(room_of(file))) << file;
    const Rooms reach = reach_of(room_of(file));
    for (const std::string& target : targets)
      EXPECT_TRUE(reach.contains(room_of(target))) << file << " includes " << target;
  }
  for (const auto& [room, others] : may_include) EXPECT_TRUE(rooms.contains(room)) << room;
}

TEST(Layers, IncludesAreFollowedToTheirEnd) {
  EXPECT_TRUE(rooms_seen_from("studies/settings").contains("mms"));
  EXPECT_TRUE(rooms_seen_from("studies/runs").contains("mms"));
  for (const auto& [room, others] : may_include) {
    const Rooms reach = reach_of(room);
    for (const std::string& seen : rooms_seen_from(room)) EXPECT_TRUE(reach.contains(seen)) << room << " sees " << seen;
  }
}

/// Solutions and solver share no line; goldens and reports see the nouns of studies, never what ties them to either.
TEST(Layers, RecordsAreFreeOfSolverAndSolutions) {
  EXPECT_FALSE(rooms_seen_from("mms").contains("solver"));
  EXPECT_FALSE(rooms_seen_from("solver").contains("mms"));
  for (const char* room : {"studies/records", "studies/claims", "studies/store", "goldens", "reports"})
    for (const char* tied : {"mms", "solver"}) EXPECT_FALSE(rooms_seen_from(room).contains(tied)) << room;
}

/// What B says of a mapping is tried on the solver's bases alone, without a problem or a run.
TEST(Layers, MappingSeesOfWhatIsRunTheBasesAlone) {
  const Rooms rooms = rooms_seen_from("studies/checks/mapping");
  EXPECT_TRUE(rooms.contains("solver"));
  for (const char* room : {"mms", "studies/problems", "studies/settings", "studies/runs"})
    EXPECT_FALSE(rooms.contains(room)) << room;
}

TEST(Layers, FitsKnowNothingOfMpm) {
  EXPECT_EQ(rooms_seen_from("studies/fits"), (Rooms{"studies/fits", "studies/support"}));
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
  EXPECT_EQ(places["sqlite3.h"], std::set<std::string>{"studies/store/database.cpp"});
  EXPECT_EQ(places["gnuplot-iostream.h"].size(), 1U);
  EXPECT_EQ(places["toml++"].size(), 1U);
}

}  // namespace mpmvv::layers_test
