#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "cli/lines.hpp"
#include "tests/cli/program.hpp"

namespace mpmvv::cli::list_test {

using testing::AllOf;
using testing::AnyOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST(ListCommand, SaysWhatDefaultBoundariesCostInOrder) {
  const Folder folder;
  const std::string problems = call(folder, "list problems").out;
  EXPECT_THAT(problems, AllOf(ContainsRegex("\nbar +1D +1 +100 +0.01 +periodic \\(none\\)\n"),
                              HasSubstr("symmetry (splines: order about 1, mirror: 2)\n"),
                              HasSubstr("free (stairs of a lattice: order about 1, fill conforming: up to 2)\n"),
                              ContainsRegex("\nimpact [^\n]* free\n")));
  EXPECT_THAT(problems, ContainsRegex("\nsquare: Wallstedt[^\n]*\n    L = 1, wave speed c = sqrt\\(E/rho\\), [^\n]*\n"
                                      "    parameter +default +unit +allowed\n    amplitude +0.1 +m +between"));
  const auto json = call(folder, "list problems --json").json()["problems"];
  for (const auto& problem : json)
    EXPECT_EQ(problem["end_time"]["default"].is_null(), problem["name"] == "impact") << "depends on the cells";
  EXPECT_EQ(json[1]["boundary_costs"], "splines: order about 1, mirror: 2");
}

/// What the table says, measured on the cube.
TEST(ListCommand, SplinesLoseOrderBetweenSymmetryPlanesAndNotBetweenMirrors) {
  const Folder folder;
  const auto ratio = [&](const std::string& boundary) {
    const auto error = [&](int cells) {
      const std::string run =
          "run --problem cube --basis bspline2 --integrator cd --ppc 2 --cfl 0.4 --boundary " + boundary;
      return call(folder, run + " --json --cells " + std::to_string(cells)).json()["error"]["l2"].get<double>();
    };
    return error(8) / error(16);
  };
  EXPECT_NEAR(std::log2(ratio("symmetry")), 1.2, 0.35);
  EXPECT_NEAR(std::log2(ratio("mirror")), 2, 0.35);
}

TEST(ListCommand, WordsStandBesideTheirKeys) {
  const Folder folder;
  EXPECT_THAT(call(folder, "list bases").out, ContainsRegex("^key +words\nbases +linear, bspline2, "));
  EXPECT_THAT(call(folder, "list").out, AllOf(ContainsRegex("\nbar +1D"), ContainsRegex("[^\n]\n\nkey +words\n"),
                                              ContainsRegex("\nmasses +lumped, consistent\n")));
}

TEST(ListCommand, HasProblemsAndWordsForPrograms) {
  const Folder folder;
  const auto all = call(folder, "list --json").json();
  EXPECT_THAT(all["bases"].get<std::vector<std::string>>(),
              testing::IsSupersetOf({"linear", "bspline2", "bspline3", "bspline2-open", "bspline3-open", "ugimp",
                                     "gimp", "cpgimp", "cpdi"}));
  EXPECT_EQ(all["problems"][0]["name"], "bar");
}

TEST(ListCommand, DialectsAreThoseOfTheCommandThatWritesFormulas) {
  const Folder folder;
  EXPECT_THAT(call(folder, "list dialects").out, ContainsRegex("dialect +of what\nc +C and C\\+\\+, with math.h"));
  const auto dialects = call(folder, "list dialects --json").json()["dialects"];
  ASSERT_EQ(dialects.size(), 6U);
  for (const auto& dialect : dialects)
    EXPECT_EQ(call(folder, "expression --problem wave --dialect " + dialect["dialect"].get<std::string>()).code, 0);
}

TEST(ListCommand, FitsATerminalOf80Columns) {
  const Folder folder;
  for (const char* list : {"", "studies", "problems", "dialects", "study-file"}) {
    std::istringstream lines(on_terminal(folder, 80, std::string("list ") + list));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(columns_of(line), 80U) << list << ": " << line;
  }
}

TEST(ListCommand, ExplainsTheStudyFileWithoutMarkdownOnATerminal) {
  const std::string reference = on_terminal(Folder(), 80, "list study-file");
  EXPECT_THAT(reference,
              AllOf(HasSubstr("source     who claims it, \"Steffen et al. 2008\" (takes text; without it none)"),
                    HasSubstr("from 'from' to 'to', then bisection\n(measuring.md)"),
                    HasSubstr("spread            largest over smallest 'norm' at the swept values")));
  EXPECT_THAT(reference, Not(AnyOf(HasSubstr("|"), HasSubstr("`"), HasSubstr("**"))));
}

}  // namespace mpmvv::cli::list_test
