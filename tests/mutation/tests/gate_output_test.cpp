#include "tests/mutation/gate_output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/mutation/program_gate.hpp"

namespace mpmvv::mutation::gate_output_test {

using testing::IsSupersetOf;

TEST(GateOutput, StudiesOfAListHaveNoCommentsAndEndings) {
  EXPECT_THAT(listed_studies("# what\nb.toml\n\n a-1.toml # why\n"), testing::ElementsAre("b", "a-1"));
}

TEST(GateOutput, TheTestThatFailedIsNamed) {
  EXPECT_EQ(failed_test("[ RUN      ] A.B\n[       OK ] A.B (0 ms)\n[ RUN      ] A.C\nx\n[  FAILED  ] A.C (1 ms)\n"),
            "A.C");
  EXPECT_EQ(failed_test("[  FAILED  ] A/0.B, where TypeParam = C (1 ms)\n"), "A/0.B");
  EXPECT_EQ(failed_test("[ RUN      ] A.B\n[       OK ] A.B (0 ms)\n[ RUN      ] A.C\n"), "A.C");
  EXPECT_EQ(failed_test(""), "before the first test");
}

TEST(GateOutput, GoldensThatDoNotPassAreNamed) {
  const char* json = R"({"results": [{"study": "s", "name": "order", "verdict": "pass"},
                                     {"study": "t", "name": "limit", "verdict": "inconclusive"},
                                     {"study": "s", "name": "error", "verdict": "fail"}]})";
  EXPECT_THAT(goldens_not_passed(json), testing::ElementsAre("s: error", "t: limit (inconclusive)"));
  EXPECT_THAT(goldens_not_passed("Segmentation"), testing::ElementsAre("the gate prints no JSON"));
}

TEST(GateOutput, TheFirstStudyOfWhichAnythingFailsEndsTheStage) {
  std::vector<std::string> asked;
  const auto caught_by = [&](std::map<std::string, std::vector<std::string>> complaints) {
    asked.clear();
    return first_catch(GateStage::quick, {"a", "b", "c"}, [&](const std::string& study) {
      asked.push_back(study);
      return complaints[study];
    });
  };
  EXPECT_FALSE(caught_by({}).caught);
  const Trial decided = caught_by({{"a", {"a: x (inconclusive)"}}, {"b", {"b: y", "b: z (inconclusive)"}}});
  EXPECT_TRUE(decided.caught);
  EXPECT_THAT(decided.by, testing::ElementsAre("b: y", "b: z (inconclusive)"));
  EXPECT_THAT(asked, testing::ElementsAre("a", "b"));
  const Trial doubtful = caught_by({{"b", {"b: x (inconclusive)"}}, {"c", {"c: y (inconclusive)"}}});
  EXPECT_TRUE(doubtful.caught);
  EXPECT_THAT(doubtful.by, testing::ElementsAre("b: x (inconclusive)"));
}

TEST(GateOutput, AnEditReachesTheTestsThatLinkIt) {
  EXPECT_THAT(test_programs("solver/grid.hpp"), testing::ElementsAre("test_solver", "test_studies", "test_cli"));
  EXPECT_EQ(test_programs("mms/bar.cpp").front(), "test_mms");
  EXPECT_THAT(test_programs("mms/c/mpmvv_mms.cpp"), testing::ElementsAre("test_c_interface"));
  EXPECT_EQ(test_programs("goldens/golden.cpp").front(), "test_goldens");
  EXPECT_THAT(test_programs("reports/csv.cpp"), testing::ElementsAre("test_reports", "test_cli"));
  EXPECT_THAT(test_programs("studies/runs/norms.hpp"), IsSupersetOf({"test_studies", "test_goldens", "test_reports"}));
}

TEST(ProgramGate, NoGoldenDependsOnTheReportOrOnOtherCodes) {
  EXPECT_FALSE(decides_the_gate("reports/csv.cpp"));
  EXPECT_FALSE(decides_the_gate("studies/codes/score.cpp"));
  EXPECT_FALSE(decides_the_gate("mms/c/mpmvv_mms.cpp"));
  for (const char* file :
       {"mms/bar.cpp", "solver/grid.hpp", "studies/fits/median.hpp", "goldens/gate.cpp", "cli/gate.cpp"})
    EXPECT_TRUE(decides_the_gate(file)) << file;
}

}  // namespace mpmvv::mutation::gate_output_test
