#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"
#include "tests/walk.hpp"

/// The pages that say how to extend the program, carried out in a copy of the tree.
namespace mpmvv::cli::how_to_nightly_test {

using testing::HasSubstr;

/// A newcomer's copy of the tree. What is done to it is built, so nightly only.
class HowToNightly : public testing::Test {
 protected:
  void SetUp() override {
    const Answer copy =
        shell("mkdir '" + tree_ + "' && cd '" MPMVV_SOURCE_DIR "' && cp -r *.md CMakeLists.txt " +
              "CMakePresets.json cmake mms solver studies goldens reports cli tests docs '" + tree_ + "' 2>&1");
    ASSERT_EQ(copy.code, 0) << copy.out;
  }

  void write(const std::string& file, const std::string& text) { std::ofstream(tree_ + "/" + file) << text; }

  void insert(const std::string& file, const std::string& before, const std::string& line) {
    std::string text = read_text(tree_ + "/" + file);
    const auto at = text.find(before);
    ASSERT_NE(at, std::string::npos) << "'" << before << "' is in no line of " << file;
    EXPECT_EQ(text.find(before, at + 1), std::string::npos) << "'" << before << "' stands twice in " << file;
    write(file, text.insert(at, line));
  }

  void write_basis() {
    write("solver/basis/bspline4.hpp", walk("basis"));
    insert("solver/basis/bases.hpp", "                              UGimp,", walk("line"));
    insert("solver/basis/bases.hpp", "#include \"solver/basis/gimp.hpp\"", "#include \"solver/basis/bspline4.hpp\"\n");
  }

  void write_setting_and_number() {
    const std::string runs = "studies/runs/run_case.cpp";
    insert("studies/cases/case.hpp", "  int repeat = 0;", walk("setting-member"));
    insert("studies/cases/setting_keys.cpp", "      {\"repeat\",", walk("setting-entry"));
    insert(runs, "    if (!record.reason.empty()) {", walk("setting-use"));
    insert("studies/records/record.hpp", "  /// Error of the Cauchy stress at the end", walk("number-member"));
    insert("studies/records/record.cpp", "      number<&Record::balance, &Balance::mass>", walk("number-entry"));
    insert(runs, "  if (c.measure.nodal_error) {", walk("number-statement"));
    insert("docs/measuring.md", "| `energy_loss` |", walk("number-line"));
  }

  void write_parts_of_a_step() {
    write("solver/velocity_update/pic_mean.hpp", walk("velocity-update"));
    const std::string updates = "solver/velocity_update/velocity_updates.hpp";
    insert(updates, "                                       Apic>", walk("velocity-update-line"));
    insert(updates, "#include \"solver/velocity_update/xpic.hpp\"",
           "#include \"solver/velocity_update/pic_mean.hpp\"\n");
    write("solver/integrator/euler.cpp", walk("integrator"));
    insert("solver/integrator/integrators.cpp", "                              rk4_integrator()}",
           walk("integrator-line"));
    insert("solver/integrator/integrators.cpp", "Integrator rk4_integrator();", "Integrator euler_integrator();\n");
    write("solver/material/st_venant_kirchhoff.hpp", walk("material"));
    insert("solver/material/materials.hpp", "                                 MieGruneisen>", walk("material-line"));
    insert("solver/material/materials.hpp", "#include \"solver/material/neo_hookean_log.hpp\"",
           "#include \"solver/material/st_venant_kirchhoff.hpp\"\n");
  }

  void write_solution() {
    write("studies/problems/bending.cpp", walk("solution"));
    insert("studies/problems/problems.cpp", "      one_particle_problem(),", walk("solution-line"));
    insert("studies/problems/problem.hpp", "Problem bar_problem();", "Problem bending_problem();\n");
  }

  /// What the page says to try, in the tree that `./run build` has configured.
  std::string carry_out(const std::string& lines) {
    const Answer answer = shell("{ set -e; cd '" + tree_ + "'; cmake --preset release; " + lines + "\n} 2>&1");
    EXPECT_EQ(answer.code, 0) << answer.out.substr(answer.out.size() > 4000 ? answer.out.size() - 4000 : 0);
    return answer.out;
  }

 private:
  Folder folder_;
  std::string tree_ = folder_ / "tree";
};

/// Fast: what the slow tests below write has a place in the sources of today. A line that moved would be found at
/// night.
using HowToAnchors = HowToNightly;

TEST_F(HowToAnchors, StandOnceInTheSources) {
  write_basis();
  write_setting_and_number();
  write_parts_of_a_step();
  write_solution();
}

/// A basis: one file, one line, and everything takes it.
TEST_F(HowToNightly, ABasisIsOneFileAndOneLine) {
  write_basis();
  const std::string out = carry_out(walk("basis-try"));
  for (const char* text : {"bspline4,", "basis bspline4", "status ok"}) EXPECT_THAT(out, HasSubstr(text));
}

/// A key and a number of a run: a member and an entry each, and everything takes them.
TEST_F(HowToNightly, ASettingAndANumberAreAMemberAndAnEntry) {
  write_setting_and_number();
  std::string study = walk("splines.toml");
  for (std::size_t at; (at = study.find("norm = \"l2\"")) != std::string::npos;)
    study.replace(at, 11, "norm = \"deformation_error\"");
  write("new-norm.toml", study.insert(study.find("slopes = [2]"), "quantity = \"deformation_error\"\n"));
  const std::string mpmvv = "build/release/mpmvv ";
  const std::string out = carry_out(walk("study-try") + mpmvv + "study new-norm.toml --db new.db\n" + mpmvv +
                                    "run --problem bar --cells 16 --ppc 4 --cfl 0.2 --blowup-speed -1 || [ $? = 2 ]");
  for (const char* text :
       {"a particle is too fast at step", "order", "blowup_speed = -1 in --blowup-speed (a number > 0)"})
    EXPECT_THAT(out, HasSubstr(text));
  EXPECT_THAT(out, testing::ContainsRegex("\"deformation\": [0-9]")) << "and not the scheme's word";
}

/// A velocity update, an integrator and a material: a file and a line each.
TEST_F(HowToNightly, WhatAStepIsMadeOfIsOneFileAndOneLineEach) {
  write_parts_of_a_step();
  const std::string out = carry_out(walk("step-try") + "build/release/mpmvv list");
  for (const char* text : {"pic-mean", "integrator euler", "st-venant-kirchhoff"}) EXPECT_THAT(out, HasSubstr(text));
  EXPECT_THAT(out, testing::ContainsRegex("status ok(.|\n)*status ok"));
}

/// A displacement field becomes a problem, and the solver converges to it.
TEST_F(HowToNightly, ASolutionIsADisplacementField) {
  write_solution();
  const std::string out = carry_out(walk("solution-try"));
  const std::string mark = "displacement at the end (m)";
  const auto coarse = out.find(mark), fine = out.rfind(mark);
  ASSERT_LT(coarse, fine) << out;
  EXPECT_GT(std::stod(out.substr(coarse + mark.size())) / std::stod(out.substr(fine + mark.size())), 3)
      << "second order";
}

}  // namespace mpmvv::cli::how_to_nightly_test
