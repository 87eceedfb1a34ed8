#include "studies/store/provenance.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/own_folder.hpp"

namespace mpmvv::store::provenance_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

TEST(Provenance, OfAProgramThatGoesOnHasTheTimeOfNow) {
  Provenance then = current_provenance();
  then.time = "2001-01-01T00:00:00Z", then.commit = "c0ffee";
  const Provenance now = with_present_time(then);
  EXPECT_GE(now.time, current_provenance().time.substr(0, 16)) << "to the minute";
  EXPECT_EQ(now.commit, "c0ffee");
}

/// `studies/checks/mapping` -> `studies/checks`, `solver/basis` -> `solver`.
std::string room_of(const std::string& folder) {
  const std::size_t first = folder.find('/');
  return folder.substr(0, folder.starts_with("studies/") ? folder.find('/', first + 1) : first);
}

/// Every folder of the real tree in which sources lie or may lie, relative to its top.
std::vector<std::string> folders_of_sources() {
  std::vector<std::string> folders;
  for (const std::string top : {"mms", "solver", "studies", "goldens", "reports", "cli"}) {
    folders.push_back(top);
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(MPMVV_SOURCE_DIR) / top))
      if (entry.is_directory()) folders.push_back(fs::relative(entry.path(), MPMVV_SOURCE_DIR).string());
  }
  return folders;
}

/// A small tree of sources and what cmake/BuildInfo.cmake makes of it.
class BuildInfo : public testing::Test {
 protected:
  void SetUp() override {
    // What git exports to hooks and to `rebase --exec` names the caller's repository, which these tests would commit
    // to.
    for (const char* variable : {"GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_COMMON_DIR"}) unsetenv(variable);
    setenv("GIT_CONFIG_GLOBAL", (root_ / "gitconfig").c_str(), 1);  // signs no commit
    write("mms/bar.cpp", "u");
    std::ofstream(root_ / "gitconfig") << "[status]\n\tshowUntrackedFiles = no\n";  // as large trees have it
    write("solver/basis/linear.hpp", "N");
    write("studies/runs/norms.hpp", "delta");
    write("studies/store/store.cpp", "select");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((source_ / name).parent_path());
    std::ofstream(source_ / name) << text;
  }

  /// The header as the build in this folder makes it.
  std::string header(const std::string& build = "build", const std::string& flags = "-O3 -Wall",
                     const std::string& in_space = "") const {
    run(
        fmt::format("cmake '-DSOURCE_DIR={0}' '-DBINARY_DIR={1}' '-DHEADER={1}/info.hpp' '-DCOMPILER=GNU 12.2.0' "
                    "-DBUILD_TYPE=Release '-DFLAGS={2}' '-DFLAGS_IN_SPACE={3}' -P '{4}/cmake/BuildInfo.cmake'",
                    source_.string(), (root_ / build).string(), flags, in_space, MPMVV_SOURCE_DIR));
    std::ifstream file(root_ / build / "info.hpp");
    return (std::stringstream() << file.rdbuf()).str();
  }

  std::string digest(const std::string& build = "build", const std::string& flags = "-O3 -Wall") const {
    return digest_in(header(build, flags));
  }
  /// The digest after each of these files is written, one after the other: by one program, as a start takes longest.
  std::vector<std::string> digests_with(const std::vector<std::pair<std::string, std::string>>& files) const {
    const fs::path build = root_ / "build";
    fs::create_directories(build);
    std::string script;
    for (std::size_t k = 0; k < files.size(); ++k) {
      const auto& [name, text] = files[k];
      fs::create_directories((source_ / name).parent_path());
      std::ofstream(build / std::to_string(k)) << text;
      script += fmt::format(
          "set(SOURCE_DIR \"{0}\")\nset(BINARY_DIR \"{1}\")\nset(HEADER \"{1}/{2}.hpp\")\nset(COMPILER \"GNU "
          "12.2.0\")\n"
          "set(BUILD_TYPE Release)\nset(FLAGS \"-O3 -Wall\")\nset(FLAGS_IN_SPACE \"\")\n"
          "file(COPY_FILE \"{1}/{2}\" \"{0}/{3}\")\ninclude(\"{4}/cmake/BuildInfo.cmake\")\n",
          source_.string(), build.string(), k, name, MPMVV_SOURCE_DIR);
    }
    std::ofstream(build / "each.cmake") << script;
    run(fmt::format("cmake -P '{}/each.cmake'", build.string()));
    std::vector<std::string> digests;
    for (std::size_t k = 0; k < files.size(); ++k) {
      std::ifstream file(build / fmt::format("{}.hpp", k));
      digests.push_back(digest_in((std::stringstream() << file.rdbuf()).str()));
    }
    return digests;
  }
  static std::string digest_in(const std::string& text) { return text.substr(text.find("digest[] = \"") + 12, 64); }

  void git(const std::string& command) const {
    run(fmt::format("git -C '{}' -c user.name=t -c user.email=t@t {} >/dev/null", source_.string(), command));
  }

  static void run(const std::string& command) { ASSERT_EQ(std::system(command.c_str()), 0) << command; }

  fs::path root_ = own_folder("build-info");
  fs::path source_ = root_ / "source";
};

TEST_F(BuildInfo, DigestFollowsTheSourcesThatDecideAResult) {
  const std::string first = digest();
  EXPECT_THAT(first, MatchesRegex("[0-9a-f]{64}"));
  write("studies/store/store.cpp", "update");
  EXPECT_EQ(digest(), first);
  for (const char* source : {"mms/bar.cpp", "solver/basis/linear.hpp", "solver/basis/cubic.hpp",
                             "studies/runs/norms.hpp", "studies/checks/mapping/kinks.cpp"}) {
    const std::string before = digest();
    write(source, "changed");
    EXPECT_NE(digest(), before) << source;
  }
}

/// Where a new source lies decides, whatever its name: every folder of the tree is one or the other.
TEST_F(BuildInfo, DigestFollowsWhatCarriesACaseOut) {
  const std::map<std::string, bool> decides{{"mms", true},
                                            {"solver", true},
                                            {"studies/cases", true},
                                            {"studies/checks", true},
                                            {"studies/codes", true},
                                            {"studies/runs", true},
                                            {"studies/problems", true},
                                            {"studies/settings", true},
                                            {"cli", false},
                                            {"goldens", false},
                                            {"reports", false},
                                            {"studies", false},
                                            {"studies/claims", false},
                                            {"studies/fits", false},
                                            {"studies/plan", false},
                                            {"studies/records", false},
                                            {"studies/store", false},
                                            {"studies/support", false}};
  std::string before = digest();
  const std::vector<std::string> folders = folders_of_sources();
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::string& folder : folders) files.emplace_back(folder + "/new.cpp", "new");
  const std::vector<std::string> digests = digests_with(files);
  for (std::size_t k = 0; k < folders.size(); ++k) {
    const auto room = decides.find(room_of(folders[k]));
    ASSERT_NE(room, decides.end()) << folders[k];
    EXPECT_EQ(digests[k] != before, room->second) << folders[k];
    before = digests[k];
  }
}

TEST_F(BuildInfo, DigestFollowsTheNameOfASource) {
  const std::string first = digest();
  fs::rename(source_ / "mms/bar.cpp", source_ / "mms/rod.cpp");
  EXPECT_NE(digest(), first);
}

TEST_F(BuildInfo, DigestFollowsCodeButNotCommentsAndLayout) {
  const std::string first = "/// Two.\nint a = 4 / 2;\nint b;";
  const std::vector<std::tuple<std::string, std::string, bool>> pairs{
      {first, "// Half; [\"two\"].\n\n  int a = 4 / 2;  // https://two; #3\n\n/// The other.\nint b;", true},
      {first, "/// Two.\nint a = 4 / 3;\nint b;", false},
      {first, "/// Two.\nint a = 4 / 2;int b;", false},
      {"auto a = \"http://a\";", "auto a = \"http://b\";", false},
      {"/* // two */ int a = 4;", "/* // two */ int a = 5;", false},
      {"auto a = R\"(b\n  c // d)\";", "auto a = R\"(b\n  c // e)\";", false},
      {"#define A 1 \\\n\n+ 1", "#define A 1 \\\n+ 1", false}};
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& [one, other, same] : pairs)
    for (const std::string& code : {one, other}) files.emplace_back("solver/step.cpp", code);
  const std::vector<std::string> digests = digests_with(files);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    EXPECT_EQ(digests[2 * k] == digests[2 * k + 1], std::get<2>(pairs[k])) << std::get<1>(pairs[k]);
}

TEST_F(BuildInfo, DigestFollowsFlagsButNotWarningsAndFolders) {
  const std::string first = digest();
  EXPECT_NE(digest("build", "-O2 -Wall"), first);
  EXPECT_EQ(digest("build", "-O3 -Wextra"), first);
  EXPECT_EQ(digest("elsewhere/build"), first);
  const auto mapped = [&](const char* build) {
    return digest(build, fmt::format("-O3 -ffile-prefix-map={}=.", (root_ / build).string()));
  };
  EXPECT_EQ(mapped("build"), mapped("other"));
}

TEST_F(BuildInfo, RegistersInSpaceAreSaidAndDecideNoResult) {
  const std::string text = header("build", "-O3", "-mavx512vl");
  EXPECT_THAT(text, HasSubstr("(-O3, in space -mavx512vl)"));
  EXPECT_EQ(digest_in(text), digest("build", "-O3"));
}

TEST_F(BuildInfo, HeaderIsLeftAloneWhileNothingChanges) {
  header();
  const fs::path file = root_ / "build/info.hpp";
  const auto long_ago = fs::last_write_time(file) - std::chrono::hours(1);
  fs::last_write_time(file, long_ago);
  header();
  EXPECT_EQ(fs::last_write_time(file), long_ago);
  write("mms/bar.cpp", "v");
  header();
  EXPECT_NE(fs::last_write_time(file), long_ago);
}

TEST_F(BuildInfo, OutsideACheckoutTheCommitIsUnknown) {
  EXPECT_THAT(header(), HasSubstr("commit[] = \"unknown\""));
  run(fmt::format("git init -q '{}'", root_.string()));
  EXPECT_THAT(header(), HasSubstr("commit[] = \"unknown\"")) << "the checkout is another project's";
}

TEST_F(BuildInfo, CommitAndDirtyComeFromGit) {
  git("init -q");
  git("add .");
  git("commit -q -m first");
  EXPECT_THAT(header(), Not(HasSubstr("unknown")));
  EXPECT_THAT(header(), HasSubstr("dirty = false"));
  write("mms/bar.cpp", "v");
  EXPECT_THAT(header(), HasSubstr("dirty = true"));
  git("commit -q -a -m second");
  EXPECT_THAT(header(), HasSubstr("dirty = false"));
  write("mms/new.cpp", "");
  EXPECT_THAT(header(), HasSubstr("dirty = true")) << "a new file is built too";
}

TEST(CurrentProvenance, TellsBuildMachineAndTime) {
  const Provenance p = current_provenance();
  EXPECT_THAT(p.digest, MatchesRegex("[0-9a-f]{64}"));
  EXPECT_THAT(p.commit, MatchesRegex("[0-9a-f]{40}|unknown"));
  EXPECT_THAT(p.compiler, MatchesRegex("[A-Za-z]+ [0-9.]+"));
  EXPECT_FALSE(p.build_type.empty());
  EXPECT_FALSE(p.cpu.empty());
  EXPECT_THAT(p.time, MatchesRegex("20[0-9]{2}-[01][0-9]-[0-3][0-9]T[0-2][0-9]:[0-5][0-9]:[0-6][0-9]Z"));
}

}  // namespace mpmvv::store::provenance_test
