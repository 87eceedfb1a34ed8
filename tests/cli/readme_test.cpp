#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/walk.hpp"

namespace mpmvv::cli {
namespace readme_test {

std::string block(const std::string& name) {
  return walk_block("README.md", name);
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

/// A newcomer's copy of the tree. What is done to it is built, so nightly only.
class ReadmeNightly : public testing::Test {
 protected:
  void SetUp() override {
    int code = 0;
    shell("mkdir '" + tree_ +
              "' && cd '" MPMVV_SOURCE_DIR
              "' && cp -r README.md CMakeLists.txt cmake mms solver studies goldens reports cli tests docs '" +
              tree_ + "'",
          code);
    ASSERT_EQ(code, 0);
  }

  void write(const std::string& file, const std::string& text) { std::ofstream(tree_ + "/" + file) << text; }

  void insert(const std::string& file, const std::string& before, const std::string& line) {
    std::string text = read_text(tree_ + "/" + file);
    const auto at = text.find(before);
    ASSERT_NE(at, std::string::npos) << before;
    write(file, text.insert(at, line));
  }

  /// Builds `target` and runs a command in the folder of the programs.
  std::string build_and(const std::string& target, const std::string& command) {
    int code = 0;
    const std::string out = shell("cmake -S '" + tree_ + "' -B '" + tree_ +
                                      "/build' -G Ninja -DCMAKE_BUILD_TYPE=Release && cmake --build '" + tree_ +
                                      "/build' --target " + target + " && cd '" + tree_ + "/build' && " + command,
                                  code);
    EXPECT_EQ(code, 0) << out.substr(out.size() > 4000 ? out.size() - 4000 : 0);
    return out;
  }

 private:
  Folder folder_;
  std::string tree_ = folder_ / "tree";
};

/// A basis: one file, one line, and everything takes it.
TEST_F(ReadmeNightly, TheBasisIsOneFileAndOneLine) {
  write("solver/basis/bspline4.hpp", block("basis"));
  insert("solver/basis/bases.hpp", "                              UGimp,", block("line"));
  insert("solver/basis/bases.hpp", "#include \"solver/basis/gimp.hpp\"", "#include \"solver/basis/bspline4.hpp\"\n");
  const std::string out = build_and("mpmvv test_solver",
                                    "./mpmvv list bases && ./test_solver && ./mpmvv run --problem bar --basis bspline4 "
                                    "--boundary periodic --integrator cd --cells 32 --ppc 4 --cfl 0.2");
  EXPECT_THAT(out, testing::HasSubstr("bspline4"));
  EXPECT_THAT(out, testing::HasSubstr("status ok"));
}

/// A key and a number of a run: a member and an entry each, and everything takes them.
TEST_F(ReadmeNightly, ASettingAndANumberAreAMemberAndAnEntry) {
  const std::string runs = "studies/runs/run_case.cpp";
  insert("studies/cases/case.hpp", "  int repeat = 0;", block("setting-member"));
  insert("studies/cases/setting_keys.cpp", "      {\"repeat\",", block("setting-entry"));
  insert(runs, "    if (!record.reason.empty()) {", block("setting-use"));
  insert("studies/records/record.hpp", "  /// Of the Cauchy stress at the end", block("number-member"));
  insert("studies/records/record.cpp", "      number<&Record::balance, &Balance::mass>", block("number-entry"));
  insert(runs, "  if (c.measure.nodal_error) {", block("number-statement"));
  insert("docs/measuring.md", "| `energy_loss` |", block("number-line"));
  std::string study = block("study");
  for (std::size_t at; (at = study.find("norm = \"l2\"")) != std::string::npos;)
    study.replace(at, 11, "norm = \"deformation_error\"");
  write("new-norm.toml", study + "quantity = \"deformation_error\"\n");
  const std::string run = "./mpmvv run --problem bar --basis bspline2 --integrator cd --cells 16 --ppc 4 --cfl 0.2 ";
  const std::string out =
      build_and("mpmvv test_studies", "./test_studies --gtest_filter='Docs*:CanonicalText.E*:RunNumbers*' && " + run +
                                          "--json && " + run + "--blowup-speed 1e-9 && " +
                                          "./mpmvv study ../new-norm.toml --db new.db && { " + run +
                                          "--blowup-speed -1; [ $? = 2 ]; }");
  for (const char* text :
       {"a particle is too fast at step", "order", "blowup_speed = -1 in --blowup-speed (a number > 0)"})
    EXPECT_THAT(out, testing::HasSubstr(text));
  EXPECT_THAT(out, testing::ContainsRegex("\"deformation\": [0-9]")) << "and not the scheme's word";
}

/// A velocity update, an integrator and a material: a file and a line each.
TEST_F(ReadmeNightly, WhatAStepIsMadeOfIsOneFileAndOneLineEach) {
  write("solver/velocity_update/pic_mean.hpp", block("velocity-update"));
  const std::string updates = "solver/velocity_update/velocity_updates.hpp";
  insert(updates, "                                       Apic>", block("velocity-update-line"));
  insert(updates, "#include \"solver/velocity_update/xpic.hpp\"", "#include \"solver/velocity_update/pic_mean.hpp\"\n");
  write("solver/integrator/euler.cpp", block("integrator"));
  insert("solver/integrator/integrators.cpp", "                              rk4_integrator()}",
         block("integrator-line"));
  insert("solver/integrator/integrators.cpp", "Integrator rk4_integrator();", "Integrator euler_integrator();\n");
  write("solver/material/st_venant_kirchhoff.hpp", block("material"));
  insert("solver/material/materials.hpp", "                                 MieGruneisen>", block("material-line"));
  insert("solver/material/materials.hpp", "#include \"solver/material/neo_hookean_log.hpp\"",
         "#include \"solver/material/st_venant_kirchhoff.hpp\"\n");
  const std::string run = "./mpmvv run --problem bar --basis bspline2 --cells 32 --ppc 4 --cfl 0.1 ";
  const auto ends_well = [&run](const std::string& scheme) { return " && " + run + scheme + " | grep 'status ok'"; };
  const std::string out = build_and("mpmvv test_solver", "./mpmvv list && ./test_solver" +
                                                             ends_well("--velocity-update pic-mean --integrator usl") +
                                                             ends_well("--velocity-update flip --integrator euler"));
  for (const std::string word : {"pic-mean", "euler", "st-venant-kirchhoff"})
    EXPECT_THAT(out, testing::HasSubstr(word));
}

/// A displacement field becomes a problem, and the solver converges to it.
TEST_F(ReadmeNightly, TheSolutionIsADisplacementField) {
  write("studies/problems/bending.cpp", block("solution"));
  insert("studies/problems/problems.cpp", "      one_particle_problem(),", block("solution-line"));
  insert("studies/problems/problem.hpp", "Problem bar_problem();", "Problem bending_problem();\n");
  const std::string run =
      "./mpmvv run --problem bending --basis bspline3 --integrator cd --ppc 4 --cfl 0.2 --json --cells ";
  const std::string out = build_and("mpmvv", run + "16 && echo SPLIT && " + run + "32");
  const auto error = [&out](std::size_t from) {
    const auto begin = out.find('{', from);
    return nlohmann::json::parse(out.substr(begin, out.find("\n}", begin) + 2 - begin))["error"]["l2"].get<double>();
  };
  const auto split = out.find("SPLIT");
  ASSERT_NE(split, std::string::npos);
  EXPECT_GT(error(out.rfind("\n{", split)) / error(split), 3) << "second order";
}

}  // namespace readme_test
}  // namespace mpmvv::cli
