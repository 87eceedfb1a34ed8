#include "studies/study_runner.hpp"

#include <gtest/gtest.h>

#include "tests/studies/store_samples.hpp"

namespace mpmvv {
namespace study_runner_test {

using store_samples::StoreTest;
using StudyRunner = StoreTest;

constexpr const char* text = R"(title = "Bar"
claims = []
[fixed]
problem = "bar"
boundary = "periodic"
integrator = "cd"
ppc = 2
cfl = 0.4
steps = 20
[[series]]
name = "quadratic"
basis = "bspline2"
[[series]]
name = "cubic"
basis = "bspline3"
[sweep]
cells = [4, 8, 16, 32]
)";

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
      EXPECT_EQ(outcomes[0][0].result.series[s].points[k].y.at("l2"),
                outcomes[1][0].result.series[s].points[k].y.at("l2"));
}

TEST_F(StudyRunner, WhatTheMachineCouldNotDoIsTriedAgain) {
  const auto file = folder_ / "bar.toml";
  std::ofstream(file) << text;
  const StudyPlan plan = read_study(file);
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  const std::vector<Failure> failures{Failure::of_machine, Failure::of_case, Failure::none, Failure::of_machine};
  for (std::size_t k = 0; k < failures.size(); ++k) {
    Record record;
    record.the_case = replicates_at(plan, plan.series[0], plan.values[k]).front();
    record.status = Status::failed;
    record.failure = failures[k];
    store.keep(record, current_provenance());
  }
  for (const std::size_t ran : {7U, 0U}) {
    RunnerCounts counts;
    const StudyOutcome outcome = run_studies({plan}, store, {}, counts).front();
    EXPECT_EQ(counts.ran, ran);
    EXPECT_EQ(outcome.failed, 1U);
    EXPECT_EQ(outcome.result.series[0].points[1].status, Status::failed);
  }
}

}  // namespace study_runner_test
}  // namespace mpmvv
