#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace mpmvv {
namespace {

/// The fenced block that follows `<!-- walk: NAME -->` in the README.
std::string block(const std::string& name) {
  const std::string readme = read_text(std::string(MPMVV_SOURCE_DIR) + "/README.md");
  const auto mark = readme.find("<!-- walk: " + name + " -->");
  EXPECT_NE(mark, std::string::npos) << name;
  const auto begin = readme.find('\n', readme.find("```", mark)) + 1;
  return readme.substr(begin, readme.find("```", begin) - begin);
}

std::string shell(const std::string& command, int& code) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string out;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) out.append(buffer.data(), n);
  const int status = pclose(pipe);
  code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return out;
}

TEST(Readme, TheStudyRunsAsPrinted) {
  const Folder folder;
  const std::string file = folder.write("my-study.toml", block("study"));
  const Answer study = call(folder, "study " + file + " --db " + (folder / "my.db"));
  ASSERT_EQ(study.code, 0) << study.err;
  EXPECT_THAT(study.out, testing::HasSubstr("10 cases run"));
  EXPECT_EQ(call(folder, "report --db " + (folder / "my.db") + " --out " + (folder / "report") + " --goldens " +
                             (folder / "none"))
                .code,
            0);
  EXPECT_TRUE(std::filesystem::exists(folder / "report/figures/my-study.svg"));
}

/// A newcomer's basis: one file, one line, and everything takes it. Builds a copy of the tree, so nightly only.
TEST(ReadmeNightly, TheBasisIsOneFileAndOneLine) {
  const Folder folder;
  const std::string tree = folder / "tree";
  int code = 0;
  shell("mkdir '" + tree +
            "' && cd '" MPMVV_SOURCE_DIR
            "' && cp -r CMakeLists.txt cmake mms solver studies goldens reports cli tests '" +
            tree + "'",
        code);
  ASSERT_EQ(code, 0);
  std::ofstream(tree + "/solver/basis/bspline4.hpp") << block("basis");
  std::string words = read_text(tree + "/solver/words.hpp");
  const std::string before = "                              UGimp,";
  ASSERT_NE(words.find(before), std::string::npos);
  words.insert(words.find(before), block("line"));
  words.insert(words.find("#include \"solver/basis/gimp.hpp\""), "#include \"solver/basis/bspline4.hpp\"\n");
  std::ofstream(tree + "/solver/words.hpp") << words;
  const std::string built =
      shell("cmake -S '" + tree + "' -B '" + tree + "/build' -G Ninja -DCMAKE_BUILD_TYPE=Release && cmake --build '" +
                tree + "/build' --target mpmvv test_solver && '" + tree + "/build/mpmvv' list bases && '" + tree +
                "/build/test_solver' && '" + tree +
                "/build/mpmvv' run --problem bar --basis bspline4 --boundary periodic --integrator cd --cells 32 --ppc "
                "4 --cfl 0.2",
            code);
  EXPECT_EQ(code, 0) << built.substr(built.size() > 4000 ? built.size() - 4000 : 0);
  EXPECT_THAT(built, testing::HasSubstr("bspline4"));
  EXPECT_THAT(built, testing::HasSubstr("status ok"));
}

}  // namespace
}  // namespace mpmvv
