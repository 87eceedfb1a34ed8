#include "reports/mutant_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mpmvv::reports::mutant_table_test {

using testing::Contains;
using testing::ElementsAre;

MutantResult mutant(const std::string& name) {
  return {.name = name, .file = "solver/grid.hpp", .line = 7, .before = "a + b", .after = "a - b"};
}

MutationResults both_kinds() {
  MutationResults mutation;
  mutation.planted = {.should_show = 1, .equivalent = 1, .quick = 1, .caught = 1};
  mutation.random = {.tried = 2, .caught = 1};
  mutation.mistakes = {mutant("sign"), mutant("speed")};
  mutation.mistakes[0].unit_tests = {.caught = false};
  mutation.mistakes[0].quick = {.caught = true, .by = {"s: order", "s: error"}};
  mutation.mistakes[1].reason = "costs time only";
  mutation.survivors = {mutant("random-1")};
  return mutation;
}

TEST(MutantTables, ThereAreNoneWithoutMutants) {
  EXPECT_TRUE(mutant_tables({}, {}).empty());
}

TEST(MutantTables, SayWhatCatchesWhat) {
  const auto tables = mutant_tables(both_kinds(), {});
  ASSERT_EQ(tables.size(), 3U);
  EXPECT_THAT(tables[0].groups[0].rows[0],
              ElementsAre("planted, should show", "0 of 1 (0 %)", "1 of 1 (100 %)", "–", "1 of 1 (100 %)", ""));
  ASSERT_EQ(tables[1].groups.size(), 2U);
  EXPECT_THAT(tables[1].groups[0].rows,
              ElementsAre(ElementsAre("sign", "", "solver/grid.hpp:7", "passes", "s: order and 1 more", "–", "")));
  EXPECT_THAT(tables[1].groups[1].rows[0], Contains("costs time only"));
}

TEST(MutantTables, ASummaryHasTheScoreAndTheSurvivors) {
  MutationResults summary = both_kinds();
  summary.mistakes.clear();
  const auto tables = mutant_tables(summary, {});
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_THAT(tables[0].groups[0].rows[0], Contains("1 of 1 (100 %)"));
  EXPECT_THAT(tables[1].groups[0].rows[0], Contains("a - b"));
}

TEST(MutantTables, SurvivorsWithoutNamesHaveNoColumnForThem) {
  MutationResults summary = both_kinds();
  EXPECT_EQ(mutant_tables(summary, {})[2].columns.front(), "mutation");
  summary.survivors[0].name.clear();
  const Table survivors = mutant_tables(summary, {})[2];
  EXPECT_EQ(survivors.columns.front(), "where");
  EXPECT_THAT(survivors.groups[0].rows, ElementsAre(ElementsAre("solver/grid.hpp:7", "a + b", "a - b", "")));
}

TEST(MutantTables, OfTheRandomOnesSurvivorsAreListed) {
  const auto tables = mutant_tables(both_kinds(), {});
  ASSERT_EQ(tables[2].groups.size(), 1U);
  EXPECT_THAT(tables[2].groups[0].rows,
              ElementsAre(ElementsAre("random-1", "solver/grid.hpp:7", "a + b", "a - b", "")));
}

TEST(MutantTables, ResultsOfAnotherGateAreMarked) {
  MutationResults mutation = both_kinds();
  mutation.mistakes[0].by_earlier_gate = true;
  EXPECT_EQ(mutant_tables(mutation, {})[1].groups[0].rows[0][0], "sign (earlier gate)");
}

TEST(MutantTables, RunsWithoutAMistakeAreCountedByBuild) {
  const auto tables = mutant_tables(both_kinds(), {{.build = "clang++", .runs = 3, .judged = 14, .alarms = 2},
                                                   {.build = "g++", .runs = 1, .judged = 7, .alarms = 0}});
  ASSERT_EQ(tables.size(), 4U);
  EXPECT_THAT(tables[3].groups[0].rows,
              ElementsAre(ElementsAre("clang++", "3", "14", "2"), ElementsAre("g++", "1", "7", "0")));
}

}  // namespace mpmvv::reports::mutant_table_test
