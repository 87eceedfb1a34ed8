#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/cli/program.hpp"
#include "tests/walk.hpp"

/// The pages that say how to use the program, carried out.
namespace mpmvv::cli::how_to_test {

using testing::AllOf;
using testing::HasSubstr;

class HowTo : public testing::Test {
 protected:
  std::string follow(const std::string& lines) const {
    const Answer answer = carry_out(folder_, lines);
    EXPECT_EQ(answer.code, 0) << lines << answer.out << answer.err;
    return answer.out;
  }

  const Folder folder_;
};

TEST_F(HowTo, OneCaseRuns) {
  EXPECT_THAT(follow(walk("run")), AllOf(HasSubstr("bar with basis bspline2"), HasSubstr("status ok")));
}

TEST_F(HowTo, AnotherCodeGetsParticlesFormulasAndTheSolution) {
  follow(walk("start-particles"));
  EXPECT_THAT(read_text(folder_ / "particles.csv"), testing::StartsWith("id,X,Y,x,y,v_x,v_y,m,V,F_xx"));
  EXPECT_THAT(follow(walk("formulas")), AllOf(HasSubstr("b_x = 0.19739208802178718*sin("), HasSubstr("v0_y = 0.0")));
  EXPECT_THAT(follow(walk("particle-formulas")), HasSubstr("\n8,\""));
  const std::string points = follow(walk("solution-points"));
  EXPECT_THAT(points, AllOf(HasSubstr("X,Y,t,u_x,u_y,P_xx"), HasSubstr("X,Y,t,u_x,u_y,b_x,b_y")));
  EXPECT_EQ(std::count(points.begin(), points.end(), '\n'), 3 + 257);
}

TEST_F(HowTo, TheStudyFileIsListedKeyByKey) {
  EXPECT_EQ(follow("mpmvv list study-file"), text_of_file(MPMVV_SOURCE_DIR "/docs/study-files.md"));
  const auto listed = nlohmann::json::parse(follow("mpmvv list study-file --json"))["study-file"];
  ASSERT_FALSE(listed.empty());
  EXPECT_EQ(listed[0]["keys"][0]["key"], "title");
}

TEST_F(HowTo, AStudyFindsOrdersInTime) {
  folder_.write("time.toml", walk("time.toml"));
  EXPECT_THAT(follow(walk("time")), AllOf(HasSubstr("h^0.93"), HasSubstr("h^1.01"), HasSubstr(" 2.18 ")));
}

TEST_F(HowTo, AStudySearchesLimits) {
  folder_.write("limits.toml", walk("limits.toml"));
  EXPECT_THAT(follow(walk("limits")), testing::ContainsRegex("limit"));
  EXPECT_THAT(follow("mpmvv claims --db limits.db"), HasSubstr("confirmed"));
  EXPECT_THAT(follow(walk("plan")), HasSubstr("limits"));
  follow(walk("set"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "trial.db"));
}

TEST_F(HowTo, MachinesShareAStudy) {
  folder_.write("splines.toml", walk("splines.toml"));
  EXPECT_THAT(follow(walk("shards")), HasSubstr("\n0 cases run, "));
  EXPECT_THAT(follow(walk("submit")), HasSubstr("cluster/submit.sh"));
}

/// A folder of studies and goldens, as a machine that checks every change has it.
TEST_F(HowTo, AJobRunsGatesAndReports) {
  std::filesystem::create_directories(folder_ / "studies");
  folder_.write("splines.toml", walk("splines.toml"));
  follow(walk("study") + walk("propose") + walk("review") + "mv splines.toml studies; rm results.db");
  follow(walk("ci"));
  EXPECT_THAT(read_text(folder_ / "gate.xml"), HasSubstr("<testsuite name=\"splines\" tests=\"4\" failures=\"0\""));
  follow(walk("ci-report"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "report/index.html"));
}

TEST_F(HowTo, AWorkflowCallsTheSameCommands) {
  const std::string workflow = walk("workflow");
  std::istringstream lines(walk("ci") + walk("ci-report"));
  for (std::string line; std::getline(lines, line);) EXPECT_THAT(workflow, HasSubstr(line + "\n"));
}

TEST_F(HowTo, AStudySaysHowSureANumberIs) {
  const std::string splines = walk("splines.toml");
  folder_.write("sure.toml", splines.substr(0, splines.find("[sweep]")) + "[sweep]\ncells = [4, 6, 8, 12, 16]\n" +
                                 "[[fit]]\nnorm = \"l2\"\nwindow = [4, 16]\n" + walk("replicates") +
                                 walk("extrapolate"));
  EXPECT_THAT(follow("mpmvv study sure.toml --db sure.db --verbose"),
              AllOf(HasSubstr("30 runs that scatter by"), HasSubstr("energy_loss")));
}

}  // namespace mpmvv::cli::how_to_test
