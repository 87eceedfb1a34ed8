#include "studies/plan/study_runner.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "studies/settings/part.hpp"
#include "tests/studies/plan/two_bases.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::plan::study_runner_test {

using records::Failure;
using records::StudyResult;
using store::Store;

using store::store_samples::StoreTest;
using StudyRunner = StoreTest;

const std::string text = two_bases("4, 8, 16, 32");

TEST_F(StudyRunner, JobsShareThePoolAndTheStoreAndChangeNothing) {
  const auto file = folder_ / "bar.toml";
  std::ofstream(file) << text;
  const StudyPlan plan = read_study(file);
  std::vector<std::vector<StudyOutcome>> outcomes;
  for (const int jobs : {1, 4}) {
    Store store(folder_ / fmt::format("{}.db", jobs), Store::Mode::create_or_write);
    RunnerCounts counts;
    std::size_t seen = 0;
    RunnerOptions options;
    options.jobs = jobs;
    options.progress = [&seen](const Progress& progress) { seen = progress.done; };
    outcomes.push_back(run_studies({plan}, store, options, counts));
    EXPECT_EQ(counts.ran, 8U);
    EXPECT_EQ(seen, 8U);
  }
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t k = 0; k < 4; ++k)
      for (const char* error : {"l1", "l2", "linf"})
        EXPECT_EQ(outcomes[0][0].result.series[s].points[k].y.at(error),
                  outcomes[1][0].result.series[s].points[k].y.at(error));
}

TEST_F(StudyRunner, TimesWhatIsTimedWhenNothingElseWaits) {
  std::string timed = text;
  timed.replace(timed.find("ppc = 2"), 7, "ppc = 3\nrepeat = 3");
  std::ofstream(folder_ / "timed.toml") << timed;
  std::ofstream(folder_ / "bar.toml") << text;
  std::ofstream(folder_ / "check.toml") << "title = \"Jump\"\nclaims = []\ncheck = \"jump-errors\"\n";
  std::vector<StudyPlan> plans;
  for (const char* name : {"timed.toml", "check.toml", "bar.toml"}) plans.push_back(read_study(folder_ / name));
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  RunnerCounts counts;
  std::vector<std::string> labels;
  RunnerOptions options;
  options.jobs = 2;
  options.progress = [&labels](const Progress& progress) { labels.push_back(progress.label); };
  const std::vector<StudyOutcome> outcomes = run_studies(plans, store, options, counts);
  ASSERT_EQ(labels.size(), 16U);
  for (std::size_t k = 0; k < labels.size(); ++k) EXPECT_EQ(labels[k].ends_with("ppc=3"), k >= 8) << labels[k];
  for (std::size_t k = 0; k < plans.size(); ++k) EXPECT_EQ(outcomes[k].result.name, plans[k].name);
  EXPECT_EQ(store.studies(store::current_provenance().digest).size(), 3U);
}

TEST_F(StudyRunner, AskedToStopItSaysWhatIsKept) {
  const auto file = folder_ / "bar.toml";
  std::ofstream(file) << text;
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  std::stop_source source;
  std::atomic<int> finished{0};
  std::size_t told = 0, kept = 0, stops = 0;
  const auto records_in_the_store = [&] {
    const std::string csv = Store(folder_ / "r.db", Store::Mode::read).export_csv();
    return static_cast<std::size_t>(std::ranges::count(csv, '\n')) - 1;
  };
  RunnerOptions options;
  options.jobs = 2;
  options.progress = [&](const Progress&) {  // nothing is over before the user has seen three cases
    if (++finished < 3) return;
    while (!source.stop_requested()) std::this_thread::yield();
  };
  options.stop = source.get_token();
  options.on_stop = [&](const RunnerCounts& counts) { ++stops, told = counts.ran, kept = records_in_the_store(); };
  const std::jthread user([&] {
    while (finished < 3) std::this_thread::yield();
    source.request_stop();
  });
  RunnerCounts counts;
  run_studies({read_study(file)}, store, options, counts);
  EXPECT_EQ(stops, 1U);
  EXPECT_GE(told, 3U);
  EXPECT_EQ(told, kept) << "while the store is at rest";
}

TEST_F(StudyRunner, WhatTheMachineCouldNotDoIsTriedAgain) {
  const auto file = folder_ / "bar.toml";
  std::ofstream(file) << text;
  const StudyPlan plan = read_study(file);
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  const std::vector<Failure> failures{Failure::of_machine, Failure::of_case, Failure::none, Failure::of_machine};
  for (std::size_t k = 0; k < failures.size(); ++k) {
    records::Record record;
    record.the_case = replicates_at(plan, plan.series[0], plan.values[k]).front();
    record.status = records::Status::failed;
    record.failure = failures[k];
    store.keep(record, store::current_provenance());
  }
  for (const std::size_t ran : {7U, 0U}) {
    RunnerCounts counts;
    const StudyOutcome outcome = run_studies({plan}, store, {}, counts).front();
    EXPECT_EQ(counts.ran, ran);
    EXPECT_EQ(outcome.failed, 1U);
    EXPECT_EQ(outcome.result.series[0].points[1].status, records::Status::failed);
  }
}

/// The results of a study in a store of its own.
StudyResult result_of(const std::filesystem::path& folder, const std::string& name, const std::string& study) {
  const auto file = folder / (name + ".toml");
  std::ofstream(file) << study;
  Store store(folder / (name + ".db"), Store::Mode::create_or_write);
  RunnerCounts counts;
  return run_studies({read_study(file)}, store, {}, counts).front().result;
}

constexpr const char* two_bars = R"(title = "Bar"
claims = []
[[series]]
name = "linear"
basis = "linear"
[[series]]
name = "quadratic"
basis = "bspline2"
[fixed]
problem = "bar"
integrator = "usl"
ppc = 2
cells = 8
)";

TEST_F(StudyRunner, ALimitIsOfItsSeriesAndOfTheCflNumbersThatWereRun) {  // 40/n with n steps on 8 cells
  const StudyResult result = result_of(folder_, "limit", std::string(two_bars) + R"(end_time = 0.05
cfl = 0.5
[sweep]
cells = [4, 16]
[limit]
key = "cfl"
from = 0.51
to = 3.1
series = ["quadratic"]
)");
  EXPECT_FALSE(result.series[0].limit);
  for (const records::Series& series : result.series) EXPECT_EQ(series.points.size(), 2U);
  const fits::StabilityLimit& limit = result.series[1].limit.value();
  ASSERT_TRUE(limit.found);
  double last = 0;
  for (const fits::Probe& probe : limit.probes) {
    EXPECT_NEAR(40 / probe.value, std::round(40 / probe.value), 1e-9);
    EXPECT_GT(probe.value, last + 1e-9) << "each run once";
    last = probe.value;
  }
  EXPECT_LT(last, 3.1);
  EXPECT_NEAR(40 / limit.stable, 40 / limit.unstable + 1, 1e-9) << "one step more";
}

/// At an offset of 0.2 the error is beyond the bound.
TEST_F(StudyRunner, AReplicateThatBlowsUpSpeaksForItsPoint) {
  const auto replicated = [this](const std::string& offsets) {
    return result_of(folder_, "replicates",
                     fmt::format("{}end_time = 0.005\nblowup_error = 0.1325\n[sweep]\ncfl = [0.2, 0.25, 0.3]\n"
                                 "[replicates]\ngrid_offset = [{}]\n[[fit]]\nnorm = \"l2\"\nwindow = [0.2, 0.3]\n",
                                 two_bars, offsets));
  };
  for (const char* offsets : {"0.2, 0, 0.5", "0, 0.2, 0.5", "0, 0.5, 0.2"}) {
    const StudyResult result = replicated(offsets);
    for (const records::Point& point : result.series[1].points) {
      EXPECT_EQ(point.status, records::Status::unstable) << offsets;
      EXPECT_NE(point.reason, "");
      EXPECT_TRUE(point.y.empty() && point.replicates.empty());
    }
  }
  const records::Series sound = replicated("0, 0.5, 0.6").series[1];
  EXPECT_EQ(sound.orders[0].replicates->observations, 9);
  for (const records::Point& point : sound.points) {
    const std::vector<double>& l2 = point.replicates.at("l2");
    ASSERT_EQ(l2.size(), 3U);
    EXPECT_NEAR(point.y.at("l2"), std::cbrt(l2[0] * l2[1] * l2[2]), 1e-12 * l2[0]);
  }
}

constexpr const char* cubes = R"(title = "Cube"
claims = []
[[series]]
name = "cubes"
[fixed]
problem = "cube"
basis = "bspline2"
integrator = "cd"
ppc = 2
)";

TEST_F(StudyRunner, RunsAPartWhereItsMirrorImagesMakeTheRest) {
  const StudyResult result =
      result_of(folder_, "cube", std::string(cubes) + "cfl = 0.4\nsteps = 4\n[sweep]\ncells = [6, 8]\n");
  const auto& points = result.series[0].points;
  EXPECT_EQ(points[0].y.at("images"), 1) << "ghost layers on both sides have no room in half of it";
  EXPECT_EQ(points[1].y.at("images"), 8);
}

TEST_F(StudyRunner, RunsTheWholeWhereThePartBlowsUp) {
  Store store(folder_ / "unstable.db", Store::Mode::create_or_write);
  std::ofstream(folder_ / "unstable.toml")
      << cubes << "cfl = 0.4\nblowup_error = 1e-9\nsteps = 4\n[sweep]\ncells = [10]\n";
  const StudyPlan plan = read_study(folder_ / "unstable.toml");
  RunnerCounts counts;
  run_studies({plan}, store, {}, counts);
  const auto record = store.find(replicates_at(plan, plan.series[0], 10).front(), store::current_provenance().digest);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->status, records::Status::unstable);
  EXPECT_EQ(record->images, 1);
  EXPECT_EQ(record->particles, 8000);
}

/// It took a minute before, and so all threads share it now.
TEST_F(StudyRunner, KeepsHowManyThreadsSharedACase) {
  std::ofstream(folder_ / "cube.toml") << cubes << "cfl = 0.4\nsteps = 4\n[sweep]\ncells = [8]\n";
  const StudyPlan plan = read_study(folder_ / "cube.toml");
  const cases::Case cube = sweep_cases(plan).front();
  for (const bool whole : {false, true}) {
    Store store(folder_ / fmt::format("{}.db", whole), Store::Mode::create_or_write);
    records::Record before;
    before.the_case = whole ? settings::as_whole(cube) : cube;
    before.wall_seconds = 60;
    StudyPlan now = plan;
    if (whole) now.series[0].settings.push_back({"whole", "true", ""});
    store.keep(before, store::store_samples::provenance("another"));
    RunnerOptions options;
    options.jobs = 3;
    RunnerCounts counts;
    run_studies({now}, store, options, counts);
    EXPECT_EQ(store.find(before.the_case, store::current_provenance().digest).value().threads, 3);
  }
}

TEST_F(StudyRunner, SearchesALimitOfTheWhole) {
  Store store(folder_ / "limit.db", Store::Mode::create_or_write);
  std::ofstream(folder_ / "limit.toml")
      << cubes << "cells = 10\nend_time = 0.001\n[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 0.4\nscan_ratio = 2\n";
  RunnerCounts counts;
  run_studies({read_study(folder_ / "limit.toml")}, store, {}, counts);
  EXPECT_GT(counts.ran, 1U);
  EXPECT_THAT(store.export_csv(), testing::Not(testing::HasSubstr("whole=false")));
}

/// A result that no check has made, so that one taken from the store is known by it.
TEST_F(StudyRunner, ACheckRunsAgainWhenItsStudyHasChangedAndOnlyThen) {
  const std::string study = "title = \"Jump\"\nclaims = []\ncheck = \"jump-errors\"\n";
  StudyResult kept = store::store_samples::study("check", "Jump");
  kept.kind = records::StudyKind::check, kept.text = study;
  kept.values = {{"forged", 7, "seven"}};
  kept.series = {store::store_samples::series("curve", {store::store_samples::point(1, {{"y", 2}})})};
  kept.series[0].orders.resize(1);
  Store(folder_ / "check.db", Store::Mode::create_or_write).keep_study(kept, {{}}, store::current_provenance());
  const StudyResult again = result_of(folder_, "check", study);
  ASSERT_EQ(again.values.size(), 1U);
  EXPECT_EQ(again.values[0].name, "forged");
  EXPECT_TRUE(again.series[0].orders.empty()) << "fits are made anew";
  for (const char* change : {"# changed\n", "[[figure]]\ncaption = \"c\"\nxlabel = \"x\"\nylabel = \"y\"\n"}) {
    const StudyResult changed = result_of(folder_, "check", study + change);
    EXPECT_GT(changed.values.size(), 1U);
    EXPECT_NE(changed.values[0].name, "forged");
  }
}

TEST_F(StudyRunner, ACheckRunsAgainWhereTheStoreDoesNotHaveItsValues) {
  const std::string study = "title = \"Jump\"\nclaims = []\ncheck = \"jump-errors\"\n";
  StudyResult kept = store::store_samples::study("check", "Jump");
  kept.kind = records::StudyKind::check, kept.text = study;
  kept.values = {{"forged", std::nan(""), "seven"}};
  Store(folder_ / "check.db", Store::Mode::create_or_write).keep_study(kept, {{}}, store::current_provenance());
  EXPECT_NE(result_of(folder_, "check", study).values[0].name, "forged") << "NaN is NULL there";
}

}  // namespace mpmvv::plan::study_runner_test
