#include <gtest/gtest.h>

#include <algorithm>

#include "studies/plan/study_runner.hpp"
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

}  // namespace mpmvv::plan::case_pool_test
