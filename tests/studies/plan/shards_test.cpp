#include "studies/plan/shards.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "studies/plan/study_runner.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::plan::shards_test {

using cases::Case;
using store::Store;
using store::store_samples::complaint;
using store::store_samples::StoreTest;
using testing::HasSubstr;

constexpr const char* head =
    "title = \"Bar\"\nclaims = []\n[fixed]\nproblem = \"bar\"\nbasis = \"bspline2\"\nintegrator = \"cd\"\nppc = 2\n";

/// A sweep, one that shares its cases, a limit whose probes another study sweeps, two that time the same case, a check.
std::vector<StudyPlan> all_kinds() {
  const std::string bars = "[[series]]\nname = \"bars\"\n";
  const auto text = [&](const std::string& more) { return head + more; };
  return {parse_study(text("cfl = 0.4\nsteps = 20\n" + bars + "[sweep]\ncells = [4, 8, 16, 32, 64]\n"), "sweep.toml"),
          parse_study(text("cfl = 0.4\nsteps = 20\n" + bars + "[sweep]\ncells = [16, 32, 128]\n"), "again.toml"),
          parse_study(text("cells = 8\n" + bars + "[limit]\nkey = \"cfl\"\nfrom = 0.2\nto = 1.6\nscan_ratio = 2\n"),
                      "limit.toml"),
          parse_study(text("cells = 8\nwhole = true\n" + bars + "[sweep]\ncfl = [0.2, 0.3]\n"), "probes.toml"),
          parse_study(text("cfl = 0.4\nsteps = 20\nrepeat = 3\n" + bars + "[sweep]\ncells = [4, 8]\n"), "one.toml"),
          parse_study(text("cfl = 0.4\nsteps = 20\nrepeat = 3\n" + bars + "[sweep]\ncells = [8, 16]\n"), "two.toml"),
          parse_study("title = \"Kinks\"\nclaims = []\ncheck = \"gimp-kinks\"\n", "kinks.toml")};
}

std::vector<StudyPlan> shipped() {
  std::vector<StudyPlan> plans;
  for (const auto& file : std::filesystem::directory_iterator(MPMVV_SOURCE_DIR "/studies"))
    if (file.path().extension() == ".toml") plans.push_back(read_study(file.path()));
  std::ranges::sort(plans, {}, &StudyPlan::name);
  return plans;
}

std::set<Case> cases_of(const Work& work) {
  std::set<Case> cases(work.runs.begin(), work.runs.end());
  for (const std::vector<Case>& timed : work.timed) cases.insert(timed.begin(), timed.end());
  return cases;
}

/// Everything in one shard and in no other; which shards have how many seconds.
void expect_each_once(const std::vector<StudyPlan>& plans, const std::vector<Work>& works) {
  const Work all = work_of(plans);
  std::set<Case> cases;
  std::set<std::size_t> checks;
  std::set<LimitTask> limits;
  for (const Work& work : works) {
    std::set<Case> own = cases_of(work);
    for (const LimitTask& limit : work.limits) {
      EXPECT_TRUE(limits.insert(limit).second);
      for (const Case& probe : scan_cases(plans, limit)) own.insert(probe);
    }
    for (const Case& c : own) EXPECT_TRUE(cases.insert(c).second) << canonical_text(c) << " in two shards";
    for (const std::size_t check : work.checks) EXPECT_TRUE(checks.insert(check).second);
  }
  for (const Case& c : cases_of(all)) EXPECT_TRUE(cases.contains(c)) << canonical_text(c) << " in no shard";
  EXPECT_EQ(checks.size(), all.checks.size());
  EXPECT_EQ(limits.size(), all.limits.size());
}

TEST(Shards, HaveAllOfTheWorkEachOnce) {
  for (const std::vector<StudyPlan>& plans : {all_kinds(), shipped()})
    for (const std::size_t shards : {1UL, 2UL, 9UL}) expect_each_once(plans, split(plans, CostModel(nullptr), shards));
}

/// Of the probes of this limit some have a part that could be run, others do not; and of each the end time differs.
TEST(Shards, LeaveProbesOfALimitWithSweepsOverIt) {
  const std::string cube =
      "title = \"Cube\"\nclaims = []\n[fixed]\nproblem = \"cube\"\nbasis = \"bspline2\"\ncells = 8\nppc = 2\n";
  for (const std::string steps : {"", "steps = 40\n"}) {
    const std::vector<StudyPlan> plans{
        parse_study(cube + steps + "[[series]]\nname = \"cubes\"\n[sweep]\ncfl = [0.3, 0.45, 0.55, 0.8, 1.0]\n" +
                        "[limit]\nkey = \"cfl\"\nfrom = 0.2\nto = 1.0\n",
                    "cube.toml"),
        parse_study(cube + "whole = true\n" + steps + "[[series]]\nname = \"cubes\"\n[sweep]\ncfl = [0.2, 1.0]\n",
                    "ends.toml")};
    const std::vector<Work> works = split(plans, CostModel(nullptr), 2);
    expect_each_once(plans, works);
    for (const Work& work : works) EXPECT_EQ(work.runs.empty(), work.limits.empty());
  }
}

TEST(Shards, LeaveTogetherWhatIsTimedInOneStudy) {
  const std::vector<StudyPlan> plans = all_kinds();
  const std::vector<Work> works = split(plans, CostModel(nullptr), 5);
  const auto timing = std::ranges::count_if(works, [](const Work& work) { return !work.timed.empty(); });
  EXPECT_EQ(timing, 1) << "the two studies that time the same case";
}

TEST(Shards, AreAsLongAsTheirLongestPieceAllows) {
  const std::vector<StudyPlan> plans = shipped();
  const CostModel costs(nullptr);
  const double all = demand(plans, work_of(plans), costs, 1).seconds;
  std::vector<double> seconds;
  for (const Work& work : split(plans, costs, 4)) seconds.push_back(demand(plans, work, costs, 1).seconds);
  EXPECT_LT(std::ranges::max(seconds), 1.1 * all / 4);
}

/// A search that three studies ask for, and six runs of which each takes about half as long.
TEST(Shards, CountARunOnceThatSeveralStudiesAskFor) {
  const std::string bars = "cells = 8\n[[series]]\nname = \"bars\"\n";
  const std::string search = "[limit]\nkey = \"cfl\"\nfrom = 0.2\nto = 1.6\nscan_ratio = 2\n";
  const std::string swept = "[sweep]\nshuffle = [1, 2, 3, 4, 5, 6]\n";
  const auto study = [&](const std::string& text) { return parse_study(head + text, "bars.toml"); };
  const StudyPlan runs = study("cfl = 0.2\n" + bars + swept), limit = study(bars + search);
  const std::vector<StudyPlan> plans{runs, limit, limit, study(bars + search + "[sweep]\ncfl = [0.2, 0.8]\n"), runs};
  const CostModel costs(nullptr);
  const auto needed = [&](const std::vector<StudyPlan>& of) { return demand(of, work_of(of), costs, 1); };
  const double all = needed(plans).seconds;
  EXPECT_NEAR(all, needed({runs, limit}).seconds, 1e-9 * all);
  for (const Work& work : split(plans, costs, 2)) EXPECT_LT(demand(plans, work, costs, 1).seconds, 0.6 * all);
}

TEST(Shards, AskForTheMemoryOfTheCasesThatRunAtOnce) {
  const std::vector<StudyPlan> plans = all_kinds();
  const Work work = work_of(plans);
  const Demand one = demand(plans, work, CostModel(nullptr), 1), two = demand(plans, work, CostModel(nullptr), 2);
  EXPECT_GT(one.memory, 1000);
  EXPECT_GT(two.memory, one.memory);
  EXPECT_LT(two.memory, 2 * one.memory) << "the largest and the next one";
  EXPECT_LT(two.seconds, one.seconds);
}

TEST(Shards, AreNamedByNumbers) {
  EXPECT_EQ(shard_from("2/8").number, 2U);
  EXPECT_EQ(shard_from("2/8").of, 8U);
  for (const char* wrong : {"", "2", "/", "0/3", "4/3", "-1/3", "1/3x", "a/b", "1/10001"})
    EXPECT_THAT(complaint([&] { shard_from(wrong); }), HasSubstr("as in --shard 2/8")) << wrong;
}

/// What a study found, but for what a clock says.
std::string findings(const records::StudyResult& study) {
  std::string text = study.name;
  for (const records::Series& series : study.series) {
    text += fmt::format("\n{} limit {}", series.name, series.limit ? series.limit->value() : -1);
    for (const records::Point& point : series.points)
      if (point.y.contains("l2")) text += fmt::format(" {}: {}", point.x, point.y.at("l2"));
  }
  for (const auto& value : study.values) text += fmt::format("\n{} {}", value.name, value.value);
  return text;
}

using ShardRuns = StoreTest;

TEST_F(ShardRuns, GiveTogetherWhatOneMachineGivesAndLeaveNothingToRun) {
  const std::vector<StudyPlan> plans = all_kinds();
  RunnerCounts counts, together;
  std::vector<std::filesystem::path> files;
  for (const Work& work : split(plans, CostModel(nullptr), 3)) {
    files.push_back(folder_ / fmt::format("{}.db", files.size()));
    Store store(files.back(), Store::Mode::create_or_write);
    const ShardOutcome outcome = run_shard(plans, work, store, {}, counts);
    EXPECT_EQ(outcome.failed, 0U);
    EXPECT_THAT(outcome.troubles, testing::IsEmpty());
    together.ran += counts.ran;
    run_shard(plans, work, store, {}, counts);
    EXPECT_EQ(counts.ran, 0U) << "it goes on from its own store";
  }
  EXPECT_EQ(Store::merge(file_, files), static_cast<std::int64_t>(together.ran)) << "no case ran twice";
  Store merged(file_, Store::Mode::write), whole(folder_ / "whole.db", Store::Mode::create_or_write);
  const auto here = run_studies(plans, merged, {}, counts);
  EXPECT_EQ(counts.ran, 0U);
  const auto there = run_studies(plans, whole, {}, counts);
  EXPECT_EQ(counts.ran, together.ran);
  for (std::size_t k = 0; k < plans.size(); ++k) EXPECT_EQ(findings(here[k].result), findings(there[k].result));
}

}  // namespace mpmvv::plan::shards_test
