#include "reports/mutant_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mpmvv::reports {
namespace mutant_table_test {

using testing::Contains;
using testing::ElementsAre;

Mutant planted(const std::string& name, std::vector<Trial> trials) {
  Mutant mutant;
  mutant.name = name;
  mutant.file = "solver/grid.hpp";
  mutant.line = 7;
  mutant.before = "a + b";
  mutant.after = "a - b";
  mutant.trials = std::move(trials);
  return mutant;
}

std::vector<Mutant> both_kinds() {
  std::vector<Mutant> mutants{
      planted("sign", {{GateStage::unit_tests, false, {}, 1}, {GateStage::quick, true, {"s: order", "s: error"}, 1}}),
      planted("speed", {}), planted("random-1", {}), planted("random-2", {})};
  mutants[1].reason = "costs time only";
  mutants[2].kind = mutants[3].kind = Mutant::Kind::random;
  mutants[3].trials = {{GateStage::quick, true, {"s: order"}, 1}};
  return mutants;
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

TEST(MutantTables, OfTheRandomOnesSurvivorsAreListed) {
  const auto tables = mutant_tables(both_kinds(), {});
  ASSERT_EQ(tables[2].groups.size(), 1U);
  EXPECT_THAT(tables[2].groups[0].rows,
              ElementsAre(ElementsAre("random-1", "solver/grid.hpp:7", "a + b", "a - b", "")));
}

TEST(MutantTables, ResultsOfAnotherGateAreMarked) {
  auto mutants = both_kinds();
  mutants.emplace_back();
  mutants.back().kind = Mutant::Kind::baseline;
  mutants.back().gate = "new";
  EXPECT_EQ(mutant_tables(mutants, {})[1].groups[0].rows[0][0], "sign (earlier gate)");
}

TEST(MutantTables, RunsWithoutAMistakeAreCountedByBuild) {
  const auto tables = mutant_tables(both_kinds(), {{.build = "g++", .pass = 7},
                                                   {.build = "clang++", .pass = 6, .fail = 1},
                                                   {.build = "clang++", .pass = 7},
                                                   {.build = "clang++"}});
  ASSERT_EQ(tables.size(), 4U);
  EXPECT_THAT(tables[3].groups[0].rows,
              ElementsAre(ElementsAre("clang++", "3", "14", "2"), ElementsAre("g++", "1", "7", "0")));
}

}  // namespace mutant_table_test
}  // namespace mpmvv::reports
