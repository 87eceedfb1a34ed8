#include "tests/mutation/mutant.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "reports/mutation_claim.hpp"
#include "studies/claims/claim.hpp"
#include "tests/mutation/results.hpp"
#include "tests/mutation/score.hpp"
#include "tests/mutation/tests/samples.hpp"
#include "tests/mutation/texts.hpp"

namespace mpmvv::mutation::mutant_test {

using namespace samples;
using testing::HasSubstr;

TEST(MutantScores, CountWhatCatchesWhat) {
  const Score score = score_of(sample());
  EXPECT_EQ(score.planted, 4);
  EXPECT_EQ(score.equivalent, 1);
  EXPECT_EQ(score.planted_catches.unit_tests, 1);
  EXPECT_EQ(score.planted_catches.quick, 1);
  EXPECT_EQ(score.planted_catches.any, 2);
  EXPECT_THAT(score.missed, testing::ElementsAre("missed"));
  EXPECT_EQ(score.open, 1);
  EXPECT_EQ(score.random, 3);
  EXPECT_EQ(score.random_catches.any, 1);
  EXPECT_EQ(score.random_explained, 1);
  EXPECT_THAT(score.unexplained, testing::ElementsAre("hole"));
}

TEST(MutantScores, CountWhatNobodyHasTried) {
  std::vector<Mutant> all = sample();
  for (Mutant& m : all) m.trials.clear();
  EXPECT_EQ(score_of(all).untried, 4);
  EXPECT_EQ(score_of(all).open, 4);
  EXPECT_EQ(score_of(sample()).untried, 0);
}

/// What `mpmvv claims` says, which knows the file alone.
std::string verdict_on(const std::vector<Mutant>& mutants, const std::vector<reports::AlarmCount>& alarms) {
  const OwnFolder folder;
  std::ofstream(folder / "mutants.json") << to_json({"d1", "c0ffee", mutants});
  const auto results = reports::read_mutation_results(folder / "mutants.json");
  for (const claims::Claim& claim : claims::judge_claims({reports::mutation_study(results, alarms)}))
    if (claim.id == "X-mutants") return to_string(claim.verdict);
  return "";
}

std::vector<reports::AlarmCount> runs_of(int of_one_build, int of_another) {
  return {{.build = "g++", .runs = of_one_build, .judged = of_one_build},
          {.build = "clang++", .runs = of_another, .judged = of_another}};
}

TEST(MutantScores, JudgeTheirClaim) {
  const std::vector<reports::AlarmCount> runs = runs_of(100, 100);
  EXPECT_EQ(verdict_on({}, runs), "open");
  EXPECT_EQ(verdict_on(sample(), runs), "partly");
  std::vector<Mutant> all = sample();
  std::erase_if(all, [](const Mutant& m) { return m.name == "missed"; });
  EXPECT_EQ(verdict_on(all, runs), "partly") << "one has not met every stage";
  std::erase_if(all, [](const Mutant& m) { return m.name == "open"; });
  EXPECT_EQ(verdict_on(all, runs), "confirmed");
  all[0].trials = {caught};
  EXPECT_EQ(verdict_on(all, runs), "partly") << "the tree without a mistake does not pass";
}

TEST(MutantScores, AskForManyRunsWithoutAnAlarm) {
  std::vector<Mutant> all = sample();
  std::erase_if(all, [](const Mutant& m) { return m.name == "missed" || m.name == "open"; });
  EXPECT_EQ(verdict_on(all, runs_of(100, 99)), "partly") << "too few";
  std::vector<reports::AlarmCount> runs = runs_of(100, 100);
  EXPECT_EQ(verdict_on(all, runs), "confirmed");
  runs.back().alarms = 1;
  EXPECT_EQ(verdict_on(all, runs), "partly");
}

TEST(MutantScores, AreToldInAHundredColumns) {
  std::vector<Mutant> all = sample();
  for (int k = 0; k < 20; ++k) all.push_back(mutant("missed-number-" + std::to_string(k), {passes, quick, nightly}));
  const std::string told = text_of(score_of(all));
  EXPECT_THAT(told, HasSubstr("planted   24 should show, 2 caught:\n"));
  EXPECT_THAT(told, HasSubstr("random    3 tried, 1 caught:\n"));
  EXPECT_THAT(told, HasSubstr("          not explained: hole\n"));
  std::istringstream lines(told);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

}  // namespace mpmvv::mutation::mutant_test
