#include "studies/mutant.hpp"

#include <gmock/gmock.h>

#include "studies/claims/claim.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv {
namespace mutant_test {

using claims::Claim;
using claims::judge_claims;
using store::Store;

using namespace store::store_samples;

Mutant mutant(const std::string& name, std::vector<Trial> trials, const std::string& gate = "g1") {
  return {.name = name,
          .kind = Mutant::Kind::planted,
          .what = "a \"sign\", or two",
          .file = "solver/grid.hpp",
          .line = 12,
          .before = "a + b;\n  c",
          .after = "a - b;\n  c",
          .gate = gate,
          .builds = true,
          .trials = std::move(trials)};
}

const Trial passes{GateStage::unit_tests, false, {}, 1.5}, quick{GateStage::quick}, nightly{GateStage::nightly};
const Trial caught{GateStage::quick, true, {"s-fig10: order of 'linear' in l2", "w-one: value 'x'"}, 60};

using MutantStore = StoreTest;

TEST_F(MutantStore, AMutantComesBackAsItWasKept) {
  Store store(file_, Store::Mode::create_or_write);
  store.keep_mutant(mutant("a", {passes, caught}), provenance());
  const auto mutants = store.mutants("d1");
  ASSERT_EQ(mutants.size(), 1U);
  EXPECT_EQ(find_mutant(mutants, mutant("a", {})), &mutants[0]);
  EXPECT_EQ(find_mutant(mutants, mutant("a", {}, "g2")), nullptr);
  EXPECT_EQ(mutants[0].what, "a \"sign\", or two");
  ASSERT_EQ(mutants[0].trials.size(), 2U);
  EXPECT_EQ(mutants[0].trial(GateStage::quick)->by, caught.by);
  EXPECT_EQ(mutants[0].trial(GateStage::unit_tests)->seconds, 1.5);
  EXPECT_EQ(mutants[0].trial(GateStage::nightly), nullptr);
  EXPECT_TRUE(store.mutants("d2").empty());
  EXPECT_TRUE(store.check().empty());
}

TEST_F(MutantStore, TheLastKeepingStays) {
  Store store(file_, Store::Mode::create_or_write);
  store.keep_mutant(mutant("a", {passes}), provenance());
  store.keep_mutant(mutant("a", {passes, caught}), provenance());
  ASSERT_EQ(store.mutants("d1").size(), 1U);
  EXPECT_TRUE(store.mutants("d1")[0].caught());
  store.keep_mutant(mutant("a", {passes}, "g2"), provenance());
  EXPECT_EQ(store.mutants("d1").size(), 2U);
  ASSERT_EQ(newest(store.mutants("d1")).size(), 1U);
  EXPECT_FALSE(newest(store.mutants("d1"))[0].caught());
}

TEST_F(MutantStore, MergingCopiesWhatIsNotThere) {
  {
    Store other(folder_ / "other.db", Store::Mode::create_or_write);
    other.keep_mutant(mutant("a", {passes, caught}), provenance());
    other.keep_mutant(mutant("b", {caught}), provenance());
  }
  Store store(file_, Store::Mode::create_or_write);
  store.keep_mutant(mutant("a", {passes}), provenance());
  Store::merge(file_, folder_ / "other.db");
  const auto mutants = store.mutants("d1");
  ASSERT_EQ(mutants.size(), 2U);
  EXPECT_FALSE(mutants[0].caught());
  EXPECT_EQ(mutants[1].trial(GateStage::quick)->by, caught.by);
}

std::vector<Mutant> sample() {
  std::vector<Mutant> all{mutant("baseline", {passes}),
                          mutant("seen", {passes, caught}),
                          mutant("by tests", {{GateStage::unit_tests, true, {"A.B"}, 1}}),
                          mutant("missed", {passes, quick, nightly}),
                          mutant("open", {passes, quick}),
                          mutant("silent", {passes})};
  all[0].kind = Mutant::Kind::baseline;
  all[5].reason = "efficiency only";
  for (const char* name : {"caught", "equal", "hole", "broken"}) {
    all.push_back(mutant(name, {passes, quick, nightly}));
    all.back().kind = Mutant::Kind::random;
  }
  all[6].trials[1] = caught;
  all[7].reason = "equivalent";
  all[9].builds = false;
  return all;
}

TEST(MutantScores, CountWhatCatchesWhat) {
  const MutantScore score = score_of(sample());
  EXPECT_EQ(score.planted, 4);
  EXPECT_EQ(score.silent, 1);
  EXPECT_EQ(score.by_unit_tests, 1);
  EXPECT_EQ(score.by_quick, 1);
  EXPECT_EQ(score.by_any, 2);
  EXPECT_THAT(score.missed, testing::ElementsAre("missed"));
  EXPECT_EQ(score.open, 1);
  EXPECT_EQ(score.random, 3);
  EXPECT_EQ(score.random_caught, 1);
  EXPECT_EQ(score.random_explained, 1);
  EXPECT_THAT(score.unexplained, testing::ElementsAre("hole"));
}

std::string verdict_on(const std::vector<Mutant>& mutants, const std::vector<AlarmRun>& runs) {
  for (const Claim& claim : judge_claims({mutant_study(mutants, runs)}))
    if (claim.id == "X-mutants") return claim.verdict;
  return "";
}

TEST(MutantScores, JudgeTheirClaim) {
  std::vector<AlarmRun> runs(200, {.build = "g++", .pass = 1});
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
  std::vector<AlarmRun> runs(199, {.build = "g++", .pass = 1});
  EXPECT_EQ(verdict_on(all, runs), "partly") << "too few";
  runs.emplace_back();
  EXPECT_EQ(verdict_on(all, runs), "partly") << "one has judged nothing";
  runs.back().pass = 1;
  EXPECT_EQ(verdict_on(all, runs), "confirmed");
  runs.back().inconclusive = 1;
  EXPECT_EQ(verdict_on(all, runs), "partly");
}

}  // namespace mutant_test
}  // namespace mpmvv
