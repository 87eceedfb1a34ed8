#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::plan::study_reader_test {

using store::store_samples::complaint;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* bars =
    "title = \"Bar\"\nclaims = []\n[fixed]\nproblem = \"bar\"\nboundary = \"periodic\"\ncells = 8\nppc = 2\ncfl = 0.2\n"
    "[[series]]\nname = \"bars\"\n";

StudyPlan swept(const std::string& line, const std::string& more = "") {
  return parse_study(bars + ("[sweep]\n" + line) + more, "bar.toml");
}

TEST(StudyReader, SweepsOverAValueOfTheProblemHoweverItIsWritten) {
  for (const char* line : {"param.amplitude = [0.01, 0.02]", "\"param.amplitude\" = [0.01, 0.02]",
                           "param = { amplitude = [0.01, 0.02] }"}) {
    const StudyPlan plan = swept(line);
    EXPECT_EQ(plan.sweep, "param.amplitude") << line;
    EXPECT_THAT(plan.values, ElementsAre(0.01, 0.02)) << line;
    EXPECT_EQ(sweep_cases(plan).at(1).problem.parameters.at("amplitude"), 0.02) << line;
  }
  EXPECT_THAT(complaint([] { swept("param = 3"); }), HasSubstr("'param' is of type integer in bar.toml:12 (a table)"));
  EXPECT_THAT(complaint([] { swept("param.amplitude = [0.01]\nparam.density = [1, 2]"); }), HasSubstr("2 keys"));
  EXPECT_THAT(complaint([] { swept("param.amplitude = [0.01]\nend_time = [1, 2]"); }), HasSubstr("2 keys"));
  EXPECT_THAT(complaint([] { swept("param.volume = [0.01, 0.02]"); }), HasSubstr("unknown parameter 'volume'"));
}

TEST(StudyReader, AWindowNeedsASweep) {
  const std::string searched = "[limit]\nkey = \"cfl\"\nfrom = 0.1\nto = 1\n",
                    norm = "norm = \"l2\"\nwindow = [8, 64]\n";
  std::string text = bars;
  text.erase(text.find("cfl = 0.2\n"), 10);
  for (const char* table : {"[[fit]]\n", "[[extrapolate]]\n"})
    EXPECT_THAT(complaint([&] { parse_study(text + searched + table + norm, "bar.toml"); }),
                HasSubstr("window in bar.toml:16 of a study without a [sweep]"));
}

TEST(StudyReader, AFigureJoinsPointsByTheirValues) {
  EXPECT_THAT(swept("end_time = [0.02, 0.01, 0.04]").values, ElementsAre(0.01, 0.02, 0.04));
  EXPECT_THAT(swept("end_time = [0.04, 0.02, 0.01]").values, ElementsAre(0.04, 0.02, 0.01))
      << "falls, as it is written";
}

TEST(StudyReader, ReplicatesDifferInWhatShouldNotMatterAlone) {
  for (const char* line : {"grid_offset = [0, 0.5]", "shuffle = [1, 2]"})
    EXPECT_TRUE(swept("end_time = [0.01, 0.02]\n[replicates]\n", line).replicates) << line;
  for (const char* line : {"cells = [8, 64]", "blowup_error = [1, 2]", "\"param.amplitude\" = [0.01, 0.02]"})
    EXPECT_THAT(complaint([line] { swept("end_time = [0.01, 0.02]\n[replicates]\n", line); }),
                HasSubstr("in bar.toml:14 (known: grid_offset, shuffle)"))
        << line;
}

TEST(StudyReader, RefusesOrdersOverWhatIsNoStepSize) {
  const std::string terms = "order = [1, 2, 4, 8]\n[[fit]]\nnorm = \"l2\"\nwindow = [1, 8]\n";
  EXPECT_THAT(complaint([&] { swept(terms); }), HasSubstr("a fit in bar.toml:13 over 'order', which is no step size"));
  EXPECT_THAT(complaint([] { swept("wall_depth = [1, 2, 3, 4]\n[[extrapolate]]\nnorm = \"l2\"\nwindow = [1, 4]\n"); }),
              HasSubstr("over 'wall_depth', which is no step size"));
  for (const char* key : {"grid_offset", "shuffle", "end_time", "param.amplitude"})
    EXPECT_THAT(complaint([&] { swept(std::string(key) + " = [1, 2, 4]\n[[fit]]\nnorm = \"l2\"\nwindow = [1, 4]\n"); }),
                HasSubstr(std::string("over '") + key + "', which is no step size"));
}

TEST(StudyReader, ChecksTheSettingsThatACheckDoesNotTake) {
  const auto overridden = [](const std::string& key) {
    return parse_study("title = \"T\"\nclaims = []\ncheck = \"jump-errors\"\n", "jump.toml", {{{key, "1", "--set"}}})
        .overridden.at(0);
  };
  EXPECT_EQ(overridden("shuffle").series, 0U);
  EXPECT_EQ(overridden("shuffle").what, "shuffle = 1 changes nothing in a check");
  EXPECT_EQ(overridden("shuffle").refusal, "a check has no settings for --set");
  EXPECT_THAT(complaint([&] { overridden("nonsense"); }), HasSubstr("unknown key 'nonsense' in --set"));
}

TEST(StudyReader, RefusesTheSameFitOfASeriesTwice) {
  const auto read = [](const std::string& what, const std::string& first, const std::string& second) {
    const std::string of_norm = "[[" + what + "]]\nnorm = \"l2\"\nwindow = ";
    return complaint([&] { swept("dt = [1e-5, 2e-5, 4e-5, 8e-5]\n", of_norm + first + "\n" + of_norm + second); });
  };
  const std::string window = "[1e-5, 8e-5]", of_bars = window + "\nseries = [\"bars\"]";
  for (const char* what : {"fit", "extrapolate"})
    for (const std::string& second : {window, of_bars})
      EXPECT_THAT(read(what, window, second), HasSubstr("l2 over [1e-05, 8e-05] twice in bar.toml:16")) << what;
  EXPECT_THAT(read("fit", of_bars, "[1e-5, 4e-5]"), Not(HasSubstr("twice")));
}

}  // namespace mpmvv::plan::study_reader_test
