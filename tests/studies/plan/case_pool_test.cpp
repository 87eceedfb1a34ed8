#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "studies/plan/study_runner.hpp"
#include "studies/store/database.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::plan::case_pool_test {

using store::Store;

/// A probe of the limit at cfl = 0.5 is the run of the sweep on 8 cells.
constexpr const char* swept_and_searched = R"(title = "Bar"
claims = []
[[series]]
name = "linear"
basis = "linear"
[fixed]
problem = "bar"
integrator = "usl"
ppc = 2
cells = 8
end_time = 0.05
cfl = 0.5
[sweep]
cells = [8, 16]
[limit]
key = "cfl"
from = 0.5
to = 2
scan_ratio = 2
)";

class CountedCases : public store::store_samples::StoreTest {
 protected:
  /// Runs the study with one job, and calls `when_told` with what is told of its progress.
  RunnerCounts run(const std::function<void(const Progress&)>& when_told) {
    RunnerOptions options;
    options.progress = options.more_work = when_told;
    return run(options);
  }
  RunnerCounts run(const RunnerOptions& options) {
    RunnerCounts counts;
    Store store(file_, Store::Mode::create_or_write);
    run_studies({plan_}, store, options, counts);
    return counts;
  }

  const StudyPlan plan_ = parse_study(swept_and_searched, "bar.toml");
};

TEST_F(CountedCases, CountOnceHoweverManyAskForThem) {
  Progress last;
  const RunnerCounts counts = run([&](const Progress& progress) { last = progress; });
  EXPECT_GT(counts.ran, 2U);
  EXPECT_EQ(last.total, counts.ran);
  EXPECT_EQ(last.done, counts.ran);
}

TEST_F(CountedCases, AreDoneAlsoWhereAnotherProgramHasKeptThem) {
  const cases::Case on_8_cells = sweep_cases(plan_).front();
  Progress last;
  const RunnerCounts counts = run([&](const Progress& progress) {
    last = progress;
    if (progress.done != 1) return;
    records::Record theirs;
    theirs.the_case = on_8_cells;
    Store(file_, Store::Mode::write).keep(theirs, store::current_provenance());
  });
  EXPECT_EQ(counts.reused, 1U);
  EXPECT_EQ(last.total, counts.ran + 1);
  EXPECT_EQ(last.done, last.total);
  EXPECT_EQ(last.seconds_left, 0);
}

/// Locks the store as a process does that merges a large one into it.
class LockedStore : public CountedCases {
 protected:
  /// The options of a run that finds the store locked once its first cases have run.
  RunnerOptions locked() {
    RunnerOptions options;
    options.more_work = [this](const Progress&) {
      if (!std::exchange(was_locked_, true)) other_.execute("BEGIN IMMEDIATE");
    };
    return options;
  }

  bool was_locked_ = false;
  store::Database other_{file_, store::Database::Access::create};
};

TEST_F(LockedStore, IsWaitedForAndToldOf) {
  RunnerOptions options = locked();
  int told = 0;
  options.on_wait = [&] {
    ++told;
    other_.execute("COMMIT");
  };
  const RunnerCounts counts = run(options);
  EXPECT_EQ(told, 1);
  EXPECT_EQ(Store(file_, Store::Mode::read).contents().records, counts.ran);
}

TEST_F(LockedStore, IsWaitedForNoLongerWhenAskedToStop) {
  const auto stopped = [this] {
    RunnerOptions options = locked();
    std::stop_source source;
    options.stop = source.get_token();
    options.on_stop = [](const RunnerCounts& counts) { std::_Exit(counts.ran == 0 && counts.unkept > 0 ? 130 : 1); };
    std::jthread asking;
    options.on_wait = [&] { asking = std::jthread([&] { source.request_stop(); }); };
    run(options);
  };
  EXPECT_EXIT(stopped(), testing::ExitedWithCode(130), "");
}

}  // namespace mpmvv::plan::case_pool_test
