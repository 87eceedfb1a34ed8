#include "studies/plan/forecast.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "studies/plan/estimates.hpp"
#include "studies/plan/study_runner.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::plan::forecast_test {

using store::Store;
using testing::HasSubstr;

/// Studies of cubes, that of `cells` on the grids given.
class Forecasts : public store::store_samples::StoreTest {
 protected:
  StudyPlan study(const std::string& name, const std::string& cells, const std::string& more = "cfl = 0.4") const {
    const auto file = folder_ / (name + ".toml");
    std::ofstream(file) << "title = \"Cube\"\nclaims = []\n[fixed]\nproblem = \"cube\"\nbasis = \"bspline2\"\n"
                        << "integrator = \"cd\"\nppc = 2\nsteps = 4\n"
                        << more << "\n[[series]]\nname = \"cubes\"\n[sweep]\ncells = " << cells << "\n";
    return read_study(file);
  }
};

TEST_F(Forecasts, SayWhatWouldRunAndWhatIsThere) {
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  RunnerCounts counts;
  run_studies({study("small", "[8, 10]")}, store, {}, counts);
  const std::vector<StudyPlan> plans{study("small", "[8, 10]"), study("more", "[8, 12, 14]"),
                                     study("again", "[12, 14]")};
  const Forecast all = forecast(plans, &store, 1);
  ASSERT_EQ(all.studies.size(), 3U);
  EXPECT_EQ(all.studies[0].stored, 2U);
  EXPECT_EQ(all.studies[0].runs, 0U);
  EXPECT_THAT(all.studies[0].why, HasSubstr("all there"));
  EXPECT_EQ(all.studies[1].stored, 1U);
  EXPECT_EQ(all.studies[1].runs, 2U);
  EXPECT_EQ(all.studies[1].parts, 2U);
  EXPECT_THAT(all.studies[1].why, HasSubstr("2 of like cases"));
  EXPECT_EQ(all.studies[2].shared, 2U);
  EXPECT_EQ(all.studies[2].seconds, 0);
  EXPECT_GT(all.seconds, 0);
  EXPECT_DOUBLE_EQ(all.seconds, all.core_seconds);
  run_studies(plans, store, {}, counts);
  EXPECT_EQ(counts.ran, 2U) << "as it was said";
}

TEST_F(Forecasts, GuessWithoutAStoreAndCountScans) {
  const Forecast swept = forecast({study("swept", "[8, 16]")}, nullptr, 1);
  EXPECT_EQ(swept.studies[0].runs, 2U);
  EXPECT_THAT(swept.studies[0].why, HasSubstr("2 guessed"));
  const auto file = folder_ / "limit.toml";
  std::ofstream(file) << "title = \"Bar\"\nclaims = []\n[fixed]\nproblem = \"bar\"\nbasis = \"bspline2\"\ncells = 8\n"
                      << "integrator = \"cd\"\nppc = 2\n[[series]]\nname = \"bar\"\n"
                      << "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 0.4\nscan_ratio = 2\n";
  const StudyForecast limit = forecast({read_study(file)}, nullptr, 1).studies[0];
  EXPECT_EQ(limit.cases, 0U);
  EXPECT_EQ(limit.probes, 3U);
  EXPECT_GT(limit.seconds, 0);
}

/// Steps divide the end time: many of the values lead to the same few numbers of steps.
TEST_F(Forecasts, CountAProbeOnceThatSeveralAskFor) {
  const std::string bar =
      "title = \"Bar\"\nclaims = []\n[fixed]\nproblem = \"bar\"\nbasis = \"bspline2\"\ncells = 8\n"
      "integrator = \"cd\"\nppc = 2\n[[series]]\nname = \"bar\"\n";
  const std::string limit = bar + "[limit]\nkey = \"cfl\"\nfrom = 0.2\nto = 0.4\nscan_ratio = 1.001\n";
  const std::vector<StudyPlan> plans{parse_study(bar + "[sweep]\ncfl = [0.2, 0.4]\n", "ends.toml"),
                                     parse_study(limit, "limit.toml"), parse_study(limit, "again.toml")};
  const std::vector<cases::Case> scan = scan_cases(plans, {.plan = 1, .series = 0, .replicate = 0});
  const std::size_t different = std::set(scan.begin(), scan.end()).size();
  ASSERT_LT(different, scan.size());
  const Forecast all = forecast(plans, nullptr, 1);
  EXPECT_EQ(all.studies[0].runs, 2U);
  EXPECT_EQ(all.studies[1].probes, different - 2) << "the ends are swept";
  EXPECT_EQ(all.studies[2].probes, 0U);
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  RunnerCounts counts;
  run_studies(plans, store, {}, counts);
  EXPECT_EQ(counts.ran, different) << "all are stable, so nothing is bisected";
}

TEST_F(Forecasts, LetTheLongestStartFirstAndTimedOnesWait) {
  const StudyPlan untimed = study("untimed", "[10, 12, 16, 20]"),
                  timed = study("timed", "[8, 10]", "cfl = 0.4\nrepeat = 3");
  const Forecast one = forecast({untimed, timed}, nullptr, 1), two = forecast({untimed, timed}, nullptr, 2);
  EXPECT_EQ(one.studies[1].timed, 2U);
  EXPECT_EQ(one.studies[1].parts, 0U);
  EXPECT_DOUBLE_EQ(one.timed_seconds, 0.75 * one.studies[1].seconds) << "three of four runs";
  const double beside = one.seconds - one.timed_seconds;
  EXPECT_LT(two.seconds, one.seconds);
  EXPECT_GE(two.seconds - two.timed_seconds, beside / 2);
}

TEST_F(Forecasts, SayWhatIsTimedAnewBesideWhatIsMissing) {
  const auto timed = [&](const std::string& cells) {
    return std::vector{study("timed", cells, "cfl = 0.4\nrepeat = 3")};
  };
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  RunnerCounts counts;
  run_studies(timed("[8, 10]"), store, {}, counts);
  const StudyForecast more = forecast(timed("[8, 10, 12]"), &store, 1).studies.at(0);
  EXPECT_EQ(more.timed, 3U);
  EXPECT_EQ(more.anew, 2U);
  EXPECT_THAT(more.why, HasSubstr("1 not in the store for this program; 2 in the store timed anew"));
}

TEST_F(Forecasts, CountTheChecksThatAreNotThere) {
  const auto file = folder_ / "jump.toml";
  std::ofstream(file) << "title = \"Jump\"\nclaims = []\ncheck = \"jump-errors\"\n";
  Store store(folder_ / "r.db", Store::Mode::create_or_write);
  const Forecast before = forecast({read_study(file)}, &store, 2);
  EXPECT_EQ(before.studies.at(0).seconds, about_check);
  EXPECT_EQ(before.core_seconds, about_check);
  EXPECT_EQ(before.seconds, about_check) << "on one thread";
  RunnerCounts counts;
  run_studies({read_study(file)}, store, {}, counts);
  EXPECT_EQ(forecast({read_study(file)}, &store, 2).core_seconds, 0);
}

TEST_F(Forecasts, TakeTheTimesThatTheyAreGiven) {
  const std::vector<StudyPlan> plans{study("cube", "[8]")};
  Store costs(folder_ / "costs.db", Store::Mode::create_or_write);
  records::Record record;
  record.the_case = sweep_cases(plans[0]).at(0);
  record.wall_seconds = 10, record.threads = 4;
  costs.keep(record, store::current_provenance());
  const auto on = [&](int jobs) { return forecast(plans, work_of(plans), nullptr, CostModel(&costs), jobs); };
  EXPECT_EQ(on(1).studies.at(0).runs, 1U) << "another store has it";
  EXPECT_THAT(on(1).studies[0].why, HasSubstr("1 known of the same case"));
  EXPECT_DOUBLE_EQ(on(1).seconds, 40);
  EXPECT_DOUBLE_EQ(on(8).seconds, 5);
}

TEST(SecondsOn, ManyCoresAreThoseOfTheLongestUnlessAllShareIt) {
  EXPECT_DOUBLE_EQ(seconds_on(4, {{2}, {40}, {2}}), 40.0 / 4 + 2);
  EXPECT_DOUBLE_EQ(seconds_on(4, {{2}, {40, false}, {2}}), 40);
  EXPECT_DOUBLE_EQ(seconds_on(4, {{1}, {4}}), 4) << "too short to be shared";
  EXPECT_DOUBLE_EQ(seconds_on(2, {{10}, {10}, {10}, {10}}), 20) << "each has a core";
}

}  // namespace mpmvv::plan::forecast_test
