#include "tests/mutation/batch_bench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "studies/support/error.hpp"
#include "tests/mutation/gate_output.hpp"

namespace mpmvv::mutation::batch_bench_test {

using support::UsageError;

using std::chrono::seconds;
using testing::ElementsAre;
using testing::IsEmpty;

/// Catches by an edit's file and the stage, and logs what it does.
class FakeBench final : public SchemataBench {
 public:
  FakeBench(std::string name, std::vector<std::string>& log) : name_(std::move(name)), log_(log) {}

  bool build(const Edit* edit) override {
    edit_ = edit ? edit->file : "none";
    log_.push_back(name_ + " builds " + edit_);
    return !broken.contains(edit_);
  }
  std::vector<int> build(const std::vector<Choice>& choices) override {
    std::string names;
    std::vector<int> numbers;
    for (const Choice& choice : choices)
      if (!broken.contains(choice.edit.file)) numbers.push_back(choice.number), names += choice.edit.file;
    log_.push_back(name_ + " builds " + names);
    return numbers;
  }
  void choose(const Choice* choice) override { edit_ = choice ? choice->edit.file : "none"; }
  Trial meet(GateStage stage, seconds) override {
    log_.push_back(name_ + " " + to_string(stage) + " " + edit_);
    const bool caught = catches.contains({edit_, stage}) || (edit_ == "none" && failures_by_load-- > 0);
    return {stage, caught, caught ? std::vector<std::string>{by} : std::vector<std::string>{}, 1};
  }
  std::string complaint() const override { return "no compiler"; }

  std::set<std::pair<std::string, GateStage>> catches;
  std::set<std::string> broken;
  int failures_by_load = 0;
  std::string by = "golden";

 private:
  std::string name_, edit_;
  std::vector<std::string>& log_;
};

class BatchBenches : public testing::Test {
 protected:
  bool caught(const Edit& edit, GateStage stage) {
    EXPECT_TRUE(bench_.build(&edit));
    return bench_.meet(stage, seconds(1)).caught;
  }

  std::vector<std::string> log_;
  FakeBench alone_{"alone", log_}, together_{"together", log_};
  const Edit a_{"a", 0, "+", "-"}, b_{"b", 0, "+", "-"}, other_{"c", 0, "+", "-"};
  BatchBench bench_{alone_, together_, {a_, b_}, [](const std::string&) {}};
};

TEST_F(BatchBenches, OneBuildServesAllThatAreCaught) {
  together_.catches = {{"a", GateStage::quick}, {"b", GateStage::quick}};
  EXPECT_TRUE(caught(a_, GateStage::quick));
  EXPECT_TRUE(caught(b_, GateStage::quick));
  EXPECT_THAT(log_, ElementsAre("together builds ab", "together quick none", "together quick a", "together quick b"));
}

TEST_F(BatchBenches, WhatPassesIsNotBuiltAlone) {
  EXPECT_FALSE(caught(a_, GateStage::quick));
  EXPECT_THAT(log_, ElementsAre("together builds ab", "together quick none", "together quick a"));
}

TEST_F(BatchBenches, WhatIsOnlyInconclusiveMeetsTheStageAlone) {
  together_.catches = {{"a", GateStage::quick}};
  together_.by = "x-conv: order of 'bar' (inconclusive)";
  EXPECT_FALSE(caught(a_, GateStage::quick));
}

TEST_F(BatchBenches, AnotherGroupFollows) {
  std::vector<Edit> coming(BatchBench::most + BatchBench::least, a_);
  for (std::size_t k = 0; k < coming.size(); ++k) coming[k].at = k;
  BatchBench bench(alone_, together_, coming, [](const std::string&) {});
  together_.catches = {{"a", GateStage::quick}};
  for (const Edit& edit : coming) {
    ASSERT_TRUE(bench.build(&edit));
    EXPECT_TRUE(bench.meet(GateStage::quick, seconds(1)).caught);
  }
  EXPECT_EQ(std::ranges::count(log_, "together quick none"), 2);
}

TEST_F(BatchBenches, ASingleOneGoesAlone) {
  BatchBench bench(alone_, together_, {a_}, [](const std::string&) {});
  EXPECT_TRUE(bench.build(&a_));
  bench.meet(GateStage::quick, seconds(1));
  EXPECT_THAT(log_, ElementsAre("alone builds a", "alone quick a"));
}

TEST_F(BatchBenches, WhatCannotBeBuiltTogetherGoesAlone) {
  together_.broken = {"a"};
  together_.catches = {{"b", GateStage::quick}};
  EXPECT_FALSE(caught(a_, GateStage::quick));
  EXPECT_FALSE(caught(other_, GateStage::quick));
  EXPECT_TRUE(caught(b_, GateStage::quick));
  EXPECT_THAT(log_, ElementsAre("together builds b", "alone builds a", "alone quick a", "alone builds c",
                                "alone quick c", "together quick none", "together quick b"));
}

TEST_F(BatchBenches, ABuildThatFailsWithNoneChosenProvesNothing) {
  together_.catches = {{"none", GateStage::quick}, {"a", GateStage::quick}, {"b", GateStage::quick}};
  EXPECT_FALSE(caught(a_, GateStage::quick));
  EXPECT_FALSE(caught(b_, GateStage::quick));
}

TEST_F(BatchBenches, ABuildThatFailsOnceWithNoneChosenServesAll) {
  together_.failures_by_load = 1;
  together_.catches = {{"a", GateStage::quick}};
  EXPECT_TRUE(caught(a_, GateStage::quick));
  EXPECT_THAT(log_,
              ElementsAre("together builds ab", "together quick none", "together quick none", "together quick a"));
}

TEST_F(BatchBenches, TheNightlyGateIsMetAlone) {
  together_.catches = {{"a", GateStage::nightly}};
  EXPECT_FALSE(caught(a_, GateStage::nightly));
  EXPECT_EQ(log_.back(), "alone nightly a");
}

TEST_F(BatchBenches, WhatCompilesWithOthersHasToCompileAlone) {
  alone_.broken = {"a"};
  EXPECT_TRUE(bench_.build(&a_));
  EXPECT_THROW(bench_.meet(GateStage::nightly, seconds(1)), support::UsageError);
}

TEST(CompilersComplaints, NameTheChoicesWhoseLinesTheyName) {
  const std::map<std::string, std::vector<ChoicePlace>> places{{"solver/grid.hpp", {{3, 10, 12, 15}, {4, 20, 20, 22}}},
                                                               {"solver/team.hpp", {{5, 10, 12, 14}}}};
  EXPECT_THAT(choices_named("/x/tree/solver/grid.hpp:12:3: error: no\nsolver/team.hpp:13:1: note", places),
              ElementsAre(3));
  EXPECT_THAT(choices_named("../tree/solver/grid.hpp:20:33:   required from here", places), ElementsAre(4));
  EXPECT_THAT(choices_named("solver/grid.hpp:14:3: error: inconsistent deduction", places), ElementsAre(3));
  EXPECT_THAT(choices_named("solver/grid.hpp:14:3: error: no\nsolver/team.hpp:11:1: note", places), ElementsAre(5));
  EXPECT_THAT(choices_named("fluid_solver/grid.hpp:20:1 other/solver/grid.cpp:20:1:", places), IsEmpty());
}

TEST(CompilersComplaints, MayHaveLinesAndNumbersOfAnyLength) {
  const std::map<std::string, std::vector<ChoicePlace>> places{{"solver/grid.hpp", {{3, 10, 12, 15}}}};
  const std::string complaint = "solver/grid.hpp:12:3: error: no", name(1'000'000, 'x'), number(1'000'000, '1');
  EXPECT_THAT(choices_named(complaint + name + "\n" + name + ":" + number + ":1", places), ElementsAre(3));
  EXPECT_THAT(choices_named("address 0x1:" + number + ": in " + complaint, places), ElementsAre(3));
}

}  // namespace mpmvv::mutation::batch_bench_test
