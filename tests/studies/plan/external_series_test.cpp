#include "studies/plan/external_series.hpp"

#include <gmock/gmock.h>

#include "studies/plan/study_runner.hpp"
#include "studies/store/database.hpp"
#include "studies/support/error.hpp"
#include "tests/studies/codes/mover.hpp"

namespace mpmvv::plan::external_series_test {

using support::UsageError;
using testing::HasSubstr;

constexpr const char* both = R"(title = "Both"
[fixed]
problem = "translation"
basis = "bspline2"
ppc = 2
cfl = 0.5
[[series]]
name = "ours"
[[series]]
name = "theirs"
code = "mover"
[sweep]
cells = [4, 8, 16]
)";

class ExternalSeries : public testing::Test {
 protected:
  StudyPlan plan(const std::string& text) const { return parse_study(text, file()); }
  std::filesystem::path file() const { return mover_.top() / "both.toml"; }

  std::string complaint(const std::string& text) const {
    CodeFinder finder("");
    try {
      StudyPlan read = plan(text);
      complete_series(read, file(), finder);
    } catch (const UsageError& e) {
      return e.what();
    }
    return "";
  }

  /// Runs the study with the code that it names.
  std::vector<StudyOutcome> run(StudyPlan read, store::Store& store) const {
    CodeFinder finder("");
    EXPECT_EQ(complete_series(read, file(), finder), "");
    RunnerOptions options;
    options.codes = finder.codes();
    RunnerCounts counts;
    return run_studies({read}, store, options, counts);
  }

  const codes::Mover mover_;
};

TEST_F(ExternalSeries, OneStudyHasOursAndTheirs) {
  StudyPlan read = plan(both);
  CodeFinder finder("");
  ASSERT_EQ(complete_series(read, file(), finder), "");
  const cases::Case ours = case_at(read.series[0], "cells", 8, ""), theirs = case_at(read.series[1], "cells", 8, "");
  EXPECT_EQ(ours.scheme.basis, "bspline2");
  EXPECT_EQ(theirs.scheme.variant, "plain");
  EXPECT_EQ(theirs.scheme.code_version, mover_.code().version);
  EXPECT_EQ(theirs.scheme.adapter, mover_.code().digest);
}

TEST_F(ExternalSeries, TheirCasesAreKeptAndFoundAgain) {
  StudyPlan read = plan(both);
  CodeFinder finder("");
  complete_series(read, file(), finder);
  RunnerOptions options;
  options.codes = finder.codes();
  store::Store store(mover_.top() / "r.db", store::Store::Mode::create_or_write);
  RunnerCounts counts;
  const auto outcomes = run_studies({read}, store, options, counts);
  EXPECT_EQ(counts.ran, 6U);
  for (const auto& series : outcomes[0].result.series)
    for (const auto& point : series.points) EXPECT_LT(point.y.at("l2"), 1e-13) << series.name << point.reason;
  run_studies({read}, store, options, counts);
  EXPECT_EQ(counts.ran, 0U);
  EXPECT_EQ(counts.reused, 6U);

  const auto of_codes = store.code_series(store::current_provenance().digest);
  ASSERT_EQ(of_codes.size(), 1U);
  EXPECT_EQ(of_codes[0].series, "theirs");
  EXPECT_EQ(of_codes[0].code.name, "mover");
  EXPECT_EQ(of_codes[0].code.variant, "plain");
  EXPECT_EQ(of_codes[0].code.force_form, "reference");
  EXPECT_EQ(of_codes[0].code.version, mover_.code().version);

  mover_.script(std::string(codes::Mover::moving) + "# edited\n");
  StudyPlan again = plan(both);
  CodeFinder anew("");
  complete_series(again, file(), anew);
  options.codes = anew.codes();
  run_studies({again}, store, options, counts);
  EXPECT_EQ(counts.ran, 3U) << "another program runs anew";
}

/// The second study times the cases that it shares with the first one anew.
TEST_F(ExternalSeries, KeepTheirTimesWhereTheMachineFailsToTimeThemAnew) {
  const auto timed = [](const char* cells) {
    std::string text = both;
    text.replace(text.find("[4, 8, 16]"), 10, cells);
    return text.replace(text.find("code ="), 0, "repeat = 3\n");
  };
  const std::filesystem::path full = mover_.top() / "full";
  mover_.script("test -e '" + full.string() + "' && kill -9 $$\n" + codes::Mover::moving);
  store::Store store(mover_.top() / "r.db", store::Store::Mode::create_or_write);
  EXPECT_EQ(run(plan(timed("[4, 8]")), store)[0].failed, 0U);
  std::ofstream(full) << "no memory";
  const std::string digest = store::current_provenance().digest;
  const records::Point sound = store.studies(digest).at(0).series.at(1).points.at(0);
  StudyPlan more = parse_study(timed("[4, 8, 16]"), mover_.top() / "more.toml");
  EXPECT_EQ(run(more, store)[0].failed, 3U);
  const records::Point kept = store.studies(digest).at(0).series.at(1).points.at(0);
  EXPECT_EQ(kept.y, sound.y);
  EXPECT_EQ(kept.rounds.session, sound.rounds.session);
  std::filesystem::remove(full);
  EXPECT_EQ(run(more, store)[0].failed, 0U);
}

TEST_F(ExternalSeries, FailedRunsAreTriedAgainUnlessThatIsRefused) {
  const std::filesystem::path licence = mover_.top() / "licence";
  mover_.script("test -e '" + licence.string() + "' || exit 1\n" + codes::Mover::moving);
  StudyPlan read = plan(both);
  CodeFinder finder("");
  ASSERT_EQ(complete_series(read, file(), finder), "");
  RunnerOptions options;
  options.codes = finder.codes();
  store::Store store(mover_.top() / "r.db", store::Store::Mode::create_or_write);
  RunnerCounts counts;
  EXPECT_EQ(run_studies({read}, store, options, counts)[0].failed, 3U);
  std::ofstream(licence) << "valid";
  options.retries = false;
  EXPECT_EQ(run_studies({read}, store, options, counts)[0].failed, 3U);
  EXPECT_EQ(counts.ran, 0U);
  options.retries = true;
  EXPECT_EQ(run_studies({read}, store, options, counts)[0].failed, 0U);
  EXPECT_EQ(counts.ran, 3U);
}

/// On 8 cells the code goes on until the store takes runs again.
TEST_F(ExternalSeries, RunsThatTheStoreRefusesAreKeptWithTheNext) {
  const std::filesystem::path done = mover_.top() / "done", ready = mover_.top() / "ready",
                              file = mover_.top() / "r.db";
  mover_.script("test $(wc -l < input.txt) -gt 100 && until test -e '" + ready.string() + "'; do sleep 0.01; done\n" +
                codes::Mover::moving + "\ntouch '" + done.string() + "'\n");
  std::string text = codes::Mover::study;
  StudyPlan read = plan(text.erase(text.find("[[fit]]")).replace(text.find("[4, 8, 16]"), 10, "[4, 8]"));
  CodeFinder finder("");
  ASSERT_EQ(complete_series(read, file, finder), "");
  RunnerOptions options;
  options.jobs = 2;
  options.codes = finder.codes();
  store::Store store(file, store::Store::Mode::create_or_write);
  store::Database(file, store::Database::Access::write)
      .execute("CREATE TRIGGER refusal BEFORE INSERT ON runs BEGIN SELECT RAISE(ABORT, 'refused'); END");
  const std::jthread other([&] {
    while (!std::filesystem::exists(done)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));  // in which the store refuses the run
    store::Database(file, store::Database::Access::write).execute("DROP TRIGGER refusal");
    std::ofstream(ready) << "yes";
  });
  RunnerCounts counts;
  try {
    run_studies({read}, store, options, counts);
    ADD_FAILURE() << "nothing was refused";
  } catch (const UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("refused"));
  }
  for (const cases::Case& c : sweep_cases(read))
    EXPECT_TRUE(store.find(c, store::current_provenance().digest)) << c.resolution.cells;
}

/// A run waits until another has started, and fails where it stays alone.
TEST_F(ExternalSeries, FirstRunsOfTimedCasesAreBesideEachOther) {
  const std::string started = "'" + (mover_.top() / "started").string() + "'";
  mover_.script("echo one >> " + started + "\nk=0\nwhile test $(wc -l < " + started +
                ") -lt 2; do sleep 0.01; k=$((k + 1)); test $k -lt 300 || exit 1; done\n" + codes::Mover::moving);
  std::string timed = both;
  timed.replace(timed.find("ppc = 2"), 7, "ppc = 2\nrepeat = 3");
  StudyPlan read = plan(timed);
  CodeFinder finder("");
  ASSERT_EQ(complete_series(read, file(), finder), "");
  RunnerOptions options;
  options.codes = finder.codes();
  options.jobs = 6;
  store::Store store(mover_.top() / "r.db", store::Store::Mode::create_or_write);
  RunnerCounts counts;
  EXPECT_EQ(run_studies({read}, store, options, counts)[0].failed, 0U);
  EXPECT_EQ(counts.ran, 6U);
}

TEST_F(ExternalSeries, StabilityLimitsAreSearchedWithTheirRuns) {
  mover_.script(std::string("awk -v c=\"$2\" 'BEGIN { exit !(c > 0.7) }' && { echo blown up; exit 1; }\n") +
                codes::Mover::moving);
  std::string adapter = codes::Mover::text;
  adapter.replace(adapter.find("\"{{end_time}}\""), 14, "\"{{end_time}}\", \"{{cfl}}\"");
  mover_.adapter(adapter);
  StudyPlan read = plan(R"(title = "Limit"
[[series]]
name = "theirs"
problem = "translation"
code = "mover"
ppc = 2
cells = 4
[limit]
key = "cfl"
from = 0.1
to = 2
)");
  store::Store store(mover_.top() / "r.db", store::Store::Mode::create_or_write);
  const auto outcomes = run(read, store);
  ASSERT_TRUE(outcomes[0].result.series[0].limit.has_value()) << outcomes[0].trouble;
  EXPECT_LE(outcomes[0].result.series[0].limit->stable, 0.7);
  EXPECT_GT(outcomes[0].result.series[0].limit->unstable, 0.7);
  EXPECT_EQ(store.code_series(store::current_provenance().digest).at(0).code.name, "mover");
}

TEST_F(ExternalSeries, WithoutTheProgramItSaysHowToGetIt) {
  std::filesystem::remove(mover_.folder() / "mover");
  StudyPlan read = plan(both);
  CodeFinder finder("");
  EXPECT_THAT(complete_series(read, file(), finder), HasSubstr("MPMVV_TEST_MOVER=PROGRAM"));
}

TEST_F(ExternalSeries, MistakesAreNamed) {
  const auto with = [](const std::string& line) {
    return std::string(both).insert(std::string(both).find("[sweep]"), line);
  };
  EXPECT_THAT(complaint(with("variant = \"fast\"\n")), HasSubstr("unknown variant 'fast' of code 'mover'"));
  EXPECT_THAT(complaint(with("code_version = \"9\"\n")), HasSubstr("code_version = '9'"));
  EXPECT_THAT(complaint(with("basis = \"linear\"\n")), HasSubstr("basis in"));
  EXPECT_THAT(complaint(both + std::string("[replicates]\nshuffle = [1, 2]\n")),
              HasSubstr("no meaning for code 'mover'"));
  EXPECT_THAT(complaint(with("force_form = \"misplaced\"\n")), HasSubstr("cannot run problem 'translation'"));
  std::string other = both;
  other.replace(other.find("\"mover\""), 7, "\"shaker\"");
  EXPECT_THAT(complaint(other), HasSubstr("no adapter of code 'shaker'"));
  EXPECT_THAT(complaint(other), HasSubstr("there are: "));
}

/// Its runs would all be the same, with order 0 and no scatter.
TEST_F(ExternalSeries, TheTimeStepOfACodeThatChoosesItIsNotVaried) {
  std::string two = both;
  two.replace(two.find("name = \"ours\""), 13, "name = \"theirs, too\"\ncode = \"mover\"");
  two.replace(two.find("basis = \"bspline2\"\n"), 19, "");
  std::string by_step = both, by_both = two;
  by_step.replace(by_step.find("cells = [4, 8, 16]"), 18, "cfl = [0.2, 0.4]");
  by_step.replace(by_step.find("cfl = 0.5"), 9, "cells = 4");
  by_both.replace(by_both.find("[sweep]"), 0, "cfl = 0.25\n");
  for (const std::string& text : {by_step, by_both}) EXPECT_EQ(complaint(text), "");

  mover_.adapter(codes::Mover::text + std::string("[step]\nrule = \"own\"\n"));
  EXPECT_EQ(complaint(both), "");
  EXPECT_EQ(complaint(two), "");
  EXPECT_THAT(complaint(by_step), HasSubstr("the sweep over cfl in "));
  EXPECT_THAT(complaint(by_step), HasSubstr("of series 'theirs': code 'mover' chooses its time step itself (another"));
  EXPECT_THAT(complaint(by_both), HasSubstr("the cfl by which it differs from 'theirs"));
}

}  // namespace mpmvv::plan::external_series_test
