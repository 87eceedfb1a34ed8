#include "tests/mutation/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "studies/support/error.hpp"

namespace mpmvv::mutation::mutant_campaign_test {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

/// A gate that catches by name.
class FakeBench final : public Bench {
 public:
  bool build(const Edit* edit) override {
    edit_ = edit ? edit->file : "";
    return !broken.contains(edit_);
  }
  Trial meet(GateStage stage, seconds limit) override {
    log.push_back(edit_ + " " + to_string(stage));
    limits.push_back(limit);
    const auto found = catches.find(edit_);
    const bool caught = found != catches.end() && found->second == stage;
    return {stage, caught, caught ? std::vector<std::string>{"golden"} : std::vector<std::string>{}, 2};
  }
  std::string complaint() const override { return "no compiler"; }

  std::map<std::string, GateStage> catches;
  std::set<std::string> broken;
  std::vector<std::string> log;
  std::vector<seconds> limits;

 private:
  std::string edit_;
};

Candidate candidate(const std::string& name, Mutant::Kind kind) {
  Candidate c;
  c.mutant.name = c.mutant.file = c.edit.file = name;
  c.mutant.kind = kind;
  c.mutant.gate = "gate";
  return c;
}

class Campaigns : public testing::Test {
 protected:
  std::vector<Mutant> run(const CampaignPlan& plan) {
    const std::vector<Mutant> known = kept_;
    return run_campaign(plan, gate_, bench_,
                        {.find = [&](const Mutant& wanted) { return known_result(known, wanted); },
                         .keep =
                             [&](const Mutant& mutant) {
                               std::erase_if(kept_, [&](const Mutant& m) { return m.name == mutant.name; });
                               kept_.push_back(mutant);
                             },
                         .tell = [](const std::string&) {}});
  }

  std::string gate_ = "gate";
  FakeBench bench_;
  std::vector<Mutant> kept_;
  const Candidate planted_ = candidate("p", Mutant::Kind::planted), silent_ = candidate("q", Mutant::Kind::planted);
  const Candidate first_ = candidate("r1", Mutant::Kind::random), second_ = candidate("r2", Mutant::Kind::random),
                  third_ = candidate("r3", Mutant::Kind::random);
};

TEST_F(Campaigns, StagesComeInTheirOrderAndTheUnchangedTreeFirst) {
  bench_.catches = {{"p", GateStage::unit_tests}, {"r1", GateStage::quick}, {"r2", GateStage::unit_tests}};
  const auto results = run({{planted_, silent_}, {first_, second_, third_}, 2});
  EXPECT_THAT(bench_.log, ElementsAre(" unit tests", " quick", "p unit tests", "p quick", "q unit tests", "q quick",
                                      "r1 quick", "r2 quick", "r2 unit tests", " nightly", "q nightly"));
  ASSERT_EQ(results.size(), 5U);
  EXPECT_EQ(results[0].name, "baseline");
  EXPECT_TRUE(results[1].caught_by(GateStage::unit_tests));
  EXPECT_FALSE(results[2].caught());
  EXPECT_THAT(bench_.limits, testing::Contains(seconds(130))) << "several times the unchanged tree's 2 s";
}

TEST_F(Campaigns, WhatIsExplainedDoesNotMeetTheNightlyGate) {
  Candidate explained = first_;
  explained.mutant.reason = "equivalent";
  const auto results = run({{}, {explained, second_}, 2});
  EXPECT_THAT(bench_.log, ElementsAre(" quick", " unit tests", "r1 quick", "r1 unit tests", "r2 quick", "r2 unit tests",
                                      " nightly", "r2 nightly"));
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(results[1].reason, "equivalent");
}

TEST_F(Campaigns, WhatDoesNotCompileIsNoMutant) {
  bench_.broken = {"r1"};
  bench_.catches = {{"r2", GateStage::quick}};
  const auto results = run({{}, {first_, second_, third_}, 1});
  ASSERT_EQ(results.size(), 3U);
  EXPECT_FALSE(results[1].builds);
  EXPECT_EQ(results[2].name, "r2");
}

TEST_F(Campaigns, WhatIsKnownIsNotDoneAgain) {
  bench_.catches = {{"p", GateStage::quick}};
  run({{planted_}, {}, 0});
  bench_.log.clear();
  EXPECT_EQ(run({{planted_}, {}, 0}).size(), 2U);
  EXPECT_THAT(bench_.log, testing::IsEmpty());

  kept_.back().trials.pop_back();  // as if killed between two stages
  run({{planted_}, {}, 0});
  EXPECT_THAT(bench_.log, testing::Contains("p quick"));
  EXPECT_THAT(bench_.log, testing::Not(testing::Contains("p unit tests")));
}

TEST_F(Campaigns, WhatIsNotKnownIsToBeTried) {
  bench_.catches = {{"p", GateStage::quick}, {"r1", GateStage::quick}};
  const CampaignPlan plan{{planted_, silent_}, {first_, second_, third_}, 2};
  const auto find = [this](const Mutant& wanted) { return known_result(kept_, wanted); };
  EXPECT_THAT(edits_to_try(plan, find), ElementsAre(planted_.edit, silent_.edit, first_.edit, second_.edit));
  run({{planted_}, {first_}, 1});
  EXPECT_THAT(edits_to_try(plan, find), ElementsAre(silent_.edit, second_.edit));
}

TEST_F(Campaigns, WhatHasBeenCaughtStaysCaughtWhileTheSourcesAreTheSame) {
  bench_.catches = {{"p", GateStage::quick}};
  const auto with_gate = [this](const std::string& gate) {
    Candidate p = planted_;
    p.mutant.gate = gate_ = gate;
    bench_.log.clear();
    return run({{p}, {}, 0});
  };
  with_gate("sources/tests");
  const auto results = with_gate("sources/more tests");
  EXPECT_THAT(bench_.log, ElementsAre(" unit tests", "p unit tests"));
  EXPECT_TRUE(results[1].caught_by(GateStage::quick));
  with_gate("sources/more tests");
  EXPECT_TRUE(bench_.log.empty()) << "what has passed the new tests has passed them";
  with_gate("other sources/more tests");
  EXPECT_THAT(bench_.log, testing::Contains("p quick"));
}

TEST_F(Campaigns, AGateThatFailsOnTheUnchangedTreeProvesNothing) {
  bench_.catches = {{"", GateStage::quick}};
  try {
    run({{planted_}, {}, 0});
    ADD_FAILURE();
  } catch (const support::UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("does not pass its quick: golden"));
  }
  bench_.broken = {""};
  EXPECT_THROW(run({{silent_}, {}, 0}), support::UsageError);
}

}  // namespace mpmvv::mutation::mutant_campaign_test
