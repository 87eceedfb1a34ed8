#include <gtest/gtest.h>

#include <set>

#include "studies/plan/forecast.hpp"
#include "studies/plan/study_runner.hpp"
#include "tests/studies/plan/two_bases.hpp"
#include "tests/studies/store/store_samples.hpp"

/// Cases whose cost is measured: all of a study take turns in one session.
namespace mpmvv::plan::timed_studies_test {

using records::StudyResult;
using store::Store;
using TimedStudies = store::store_samples::StoreTest;

std::string timed_text(const std::string& cells) {
  return two_bases(cells, "repeat = 3");
}

/// The sessions in which the points of a study were timed.
std::set<std::string> sessions_of(const StudyResult& study) {
  std::set<std::string> sessions;
  for (const records::Series& series : study.series)
    for (const records::Point& point : series.points) sessions.insert(point.rounds.session);
  return sessions;
}

TEST_F(TimedStudies, TimesAllOfAStudyAnewWhereOneIsMissing) {
  const std::vector<StudyPlan> two{parse_study(timed_text("4, 8"), "bar.toml")},
      three{parse_study(timed_text("4, 8, 16"), "bar.toml")};
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  RunnerCounts counts;
  const auto first = sessions_of(run_studies(two, store, {}, counts)[0].result);
  EXPECT_EQ(first.size(), 1U);
  EXPECT_EQ(sessions_of(run_studies(two, store, {}, counts)[0].result), first);
  EXPECT_EQ(counts.reused, 4U);
  EXPECT_EQ(forecast(three, &store, 1).studies.at(0).timed, 6U);
  const auto second = sessions_of(run_studies(three, store, {}, counts)[0].result);
  EXPECT_EQ(second.size(), 1U);
  EXPECT_NE(second, first);
  EXPECT_EQ(counts.ran, 6U);
  EXPECT_EQ(counts.reused, 0U);
  EXPECT_EQ(sessions_of(store.studies(store::current_provenance().digest).at(0)), second);
  EXPECT_EQ(forecast(three, &store, 1).studies.at(0).stored, 6U);
}

TEST_F(TimedStudies, TimesStudiesThatShareACaseTogether) {
  const std::vector<StudyPlan> plans{parse_study(timed_text("4, 8"), "one.toml"),
                                     parse_study(timed_text("8, 16"), "two.toml"),
                                     parse_study(timed_text("32"), "three.toml")};
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  RunnerCounts counts;
  const auto outcomes = run_studies(plans, store, {}, counts);
  EXPECT_EQ(counts.ran, 8U);
  EXPECT_EQ(sessions_of(outcomes[0].result), sessions_of(outcomes[1].result));
  EXPECT_EQ(sessions_of(outcomes[0].result).size(), 1U);
  EXPECT_NE(sessions_of(outcomes[0].result), sessions_of(outcomes[2].result));
}

/// A case that failed is tried alone. Where it fails again, the times of the others stay.
TEST_F(TimedStudies, TimesAllOfAStudyAnewWhereOneIsSoundAtLast) {
  const std::vector<StudyPlan> plans{parse_study(timed_text("4, 8"), "bar.toml")};
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  records::Record failed;
  failed.the_case = sweep_cases(plans[0])[1];
  failed.status = records::Status::failed, failed.failure = records::Failure::of_machine;
  store.keep(failed, store::current_provenance());
  RunnerCounts counts;
  RunnerOptions options;
  options.retries = false;
  EXPECT_EQ(sessions_of(run_studies(plans, store, options, counts)[0].result).size(), 2U) << "none, and that of others";
  EXPECT_EQ(counts.ran, 3U);
  EXPECT_EQ(sessions_of(run_studies(plans, store, {}, counts)[0].result).size(), 1U);
  EXPECT_EQ(counts.ran, 5U) << "the failed one alone, then all";
}

}  // namespace mpmvv::plan::timed_studies_test
