#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <sstream>
#include <thread>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::study_test {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

// Its particles alone would take more than any address space.
constexpr const char* hopeless_study = R"(title = "Hopeless"
claims = []
[fixed]
problem = "square"
cells = 1000000
ppc = 4
steps = 1
[[series]]
name = "quadratic"
basis = "bspline2"
[limit]
key = "cfl"
from = 0.1
to = 1
)";

TEST(StudyCommand, AStudyThatCannotEndLeavesTheOthersTheirs) {
  const Folder folder;
  const auto db = folder / "r.db";
  const auto hopeless = folder.write("hopeless.toml", hopeless_study), small = folder.write("small.toml", small_study);
  const Answer answer = call(folder, "study '" + hopeless + "' '" + small + "' --db '" + db + "'");
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.err, HasSubstr("study hopeless is not kept: a probe at 0.1 failed: not enough memory"));
  EXPECT_THAT(answer.out, ContainsRegex("S-fig10 +holds +at least 1.5 +1.969 ± 0.12 +second order"));
  EXPECT_THAT(answer.out, HasSubstr("0 failed; studies not kept: 1"));
}

TEST(StudyCommand, RunsOnceAndReusesAfterwards) {
  const Folder folder;
  const std::string file = folder.write("small.toml", small_study), db = folder / "r.db";
  const Answer first = call(folder, "study " + file + " --db " + db);
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("8 cases run, 0 taken"));
  EXPECT_THAT(first.out, ContainsRegex("S-fig10 +holds"));
  EXPECT_EQ(first.err, "") << "progress is quiet when not a terminal";
  const Answer second = call(folder, "study " + file + " --db " + db);
  EXPECT_THAT(second.out, HasSubstr("0 cases run, 8 taken"));
  const auto claims = call(folder, "claims --db " + db + " --json").json()["claims"];
  const auto found = std::find_if(claims.begin(), claims.end(), [](const auto& c) { return c["id"] == "S-fig10"; });
  EXPECT_EQ((*found)["verdict"], "confirmed");
}

TEST(StudyCommand, PlanSaysWhatWouldRunAndRunsNothing) {
  const Folder folder;
  const std::string file = folder.write("small.toml", small_study), db = folder / "r.db";
  const std::string study = "study " + file + " --db " + db;
  const Answer before = call(folder, study + " --plan --json --jobs 2");
  ASSERT_EQ(before.code, 0) << before.err;
  EXPECT_FALSE(std::filesystem::exists(db));
  EXPECT_EQ(before.json()["jobs"], 2);
  EXPECT_EQ(before.json()["studies"][0]["runs"], 8);
  EXPECT_GT(before.json()["seconds"], 0);
  std::istringstream lines(on_terminal(folder, 80, "study small.toml s-fig10 x-cost --plan --db r.db"));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  ASSERT_EQ(call(folder, study).code, 0);
  const Answer after = call(folder, study + " --plan");
  EXPECT_THAT(after.out, AllOf(HasSubstr("small "), HasSubstr("all there"), HasSubstr("about 0.0 s on")));
  const std::string elsewhere = " --shard 1/1 --costs " + db + " --db " + (folder / "none.db");
  EXPECT_THAT(call(folder, "study " + file + elsewhere + " --plan --json").out, HasSubstr("8 known of the same case"));
  EXPECT_EQ(call(folder, study + " --json").code, 2) << "results have no such form";
  const Answer nowhere = call(folder, "study " + file + " --plan --db " + (folder / "none/r.db"));
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("none' for results store")) << "as the study itself would say";
}

TEST(StudyCommand, ACostCaseIsAnotherCaseAndPrintsItsCost) {
  const Folder folder;
  std::string costly = small_study;
  costly.replace(costly.find("ppc = 4"), 7, "ppc = 4\nrepeat = 3");
  const std::string plain = folder.write("small.toml", small_study), cost = folder.write("cost.toml", costly);
  const std::string db = folder / "r.db";
  ASSERT_EQ(call(folder, "study " + plain + " --db " + db).code, 0);
  const Answer answer = call(folder, "study " + plain + " " + cost + " --db " + db);
  ASSERT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("8 cases run, 8 taken"));
  const auto printed = answer.out.find("step_seconds (s) by cells");
  EXPECT_NE(printed, std::string::npos);
  EXPECT_EQ(answer.out.find("step_seconds (s) by cells", printed + 1), std::string::npos)
      << "only where it was measured";
}

TEST(StudyCommand, ReplicatesMakeAMeanAnIntervalAndATestOfTheLine) {
  const Folder folder;
  std::string text = small_study;
  text.replace(text.find("[[fit]]"), 7, "[replicates]\ngrid_offset = [0, 0.3, 0.7]\n[[fit]]");
  const std::string file = folder.write("small.toml", text), db = folder / "r.db";
  const Answer answer = call(folder, "study " + file + " --verbose --db " + db);
  ASSERT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("24 cases run"));
  EXPECT_THAT(answer.out, HasSubstr("replicates of 'bspline2' in l2: 12 runs that scatter by"));
  ASSERT_EQ(call(folder, "report --db " + db + " --out " + (folder / "report")).code, 0);
  EXPECT_THAT(read_text(folder / "report/tables/replicates/small.csv"), HasSubstr("linear,8,l2,3,"));
}

TEST(StudyCommand, ReplicatesOfALimitAreSearchedEach) {
  const Folder folder;
  const std::string text = R"(title = "Limit"
claims = []
[fixed]
problem = "bar"
cells = 8
ppc = 2
[[series]]
name = "linear"
basis = "linear"
[limit]
key = "cfl"
from = 0.2
to = 4
scan_ratio = 2
[replicates]
grid_offset = [0, 0.25]
)";
  const auto file = folder.write("limit.toml", text), db = folder / "r.db";
  const Answer answer = call(folder, "study " + file + " --db " + db);
  ASSERT_EQ(answer.code, 0) << answer.err;
  ASSERT_EQ(call(folder, "report --db " + db + " --out " + (folder / "report")).code, 0);
  const std::string probes = read_text(folder / "report/tables/probes/limit.csv");
  EXPECT_NE(probes.find("linear,cfl,4,"), probes.rfind("linear,cfl,4,")) << "one of each replicate:\n" << probes;
}

TEST(StudyCommand, ExtrapolatesWhatHasNoExactValue) {
  const Folder folder;
  std::string text = small_study;
  text.replace(text.find("[[fit]]"), 7, "[[extrapolate]]\nnorm = \"energy_loss\"\nwindow = [8, 64]\n[[fit]]");
  const Answer answer = call(folder, "study " + folder.write("small.toml", text) + " --db " + (folder / "r.db"));
  ASSERT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, ContainsRegex("bspline2 +energy_loss +8 to 64 "));
}

TEST(StudyCommand, SetOverridesEverySeriesAndSaysSoInTheStore) {
  const Folder folder;
  const std::string file = folder.write("small.toml", small_study), db = folder / "r.db";
  const Answer trial = call(folder, "study --set shuffle=3 --set ppc=2 " + file + " --db " + db);
  ASSERT_EQ(trial.code, 0);
  EXPECT_THAT(trial.out, AllOf(HasSubstr("made with --set: shuffle = 3"), Not(HasSubstr("  holds  "))));
  EXPECT_THAT(call(folder, "db export --db " + db).out, HasSubstr("ppc=2 grid_offset=0 shuffle=3"));
  for (const char* wrong : {"cells=8", "pcp=4", "ppc", "=4"})
    EXPECT_EQ(call(folder, "study " + file + " --set " + wrong + " --db " + (folder / "other.db")).code, 2) << wrong;
  const Answer twice = call(folder, "study --set ppc=2 --set ppc=3 " + file + " --db " + (folder / "other.db"));
  EXPECT_EQ(twice.code, 2);
  EXPECT_THAT(twice.err, HasSubstr("ppc = 3 in --set beside ppc = 2 in --set (one value)"));
  EXPECT_FALSE(std::filesystem::exists(folder / "other.db"));
}

TEST(StudyCommand, WhatOnlySomeSeriesTakeReachesThoseAlone) {
  const Folder folder;
  std::string text = small_study;
  text.replace(text.find("[[fit]]"), 7,
               "[[series]]\nname = \"walls\"\nbasis = \"linear\"\nboundary = \"dirichlet\"\n[[fit]]");
  const std::string file = folder.write("small.toml", text), db = folder / "r.db";
  const std::string offset = "grid_offset=0.3";
  EXPECT_EQ(call(folder, "study --set " + offset + " " + file + " --db " + db).code, 2);
  const Answer answer =
      call(folder, "study --set-where-taken " + offset + " --set-where-taken cells=9 " + file + " --db " + db);
  ASSERT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.err,
              AllOf(HasSubstr("grid_offset = 0.3 in 2 of 3 series"), HasSubstr("cells = 9 in 0 of 3 series")));
  const std::string kept = call(folder, "db export --db " + db).out;
  EXPECT_THAT(kept, ContainsRegex("boundary=periodic[^\n]*grid_offset=0.3"));
  EXPECT_THAT(kept, ContainsRegex("boundary=dirichlet[^\n]*grid_offset=0 "));
  for (const char* wrong : {"shuffle=abc", "basis=nonsense", "pcp=4"})
    EXPECT_EQ(
        call(folder, std::string("study --set-where-taken ") + wrong + " " + file + " --db " + (folder / "other.db"))
            .code,
        2)
        << wrong;
}

TEST(StudyCommand, AKilledRunLosesNoFinishedCase) {
  const Folder folder;
  std::string slow = small_study;
  slow.replace(slow.find("[8, 16, 32, 64]"), 15, "[8, 16, 32, 64, 128, 256]");
  const std::string file = folder.write("slow.toml", slow), db = folder / "r.db";
  const pid_t child = fork();
  if (child == 0) {
    freopen("/dev/null", "w", stdout);
    execl(program().c_str(), "mpmvv", "study", file.c_str(), "--jobs", "1", "--db", db.c_str(), nullptr);
    _exit(127);
  }
  const auto finished = [&] {
    const Answer exported = call(folder, "db export --db " + db);
    return exported.code == 0 ? std::count(exported.out.begin(), exported.out.end(), '\n') - 1 : 0;
  };
  for (int k = 0; k < 600 && finished() < 3; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const auto kept = finished();
  ASSERT_GE(kept, 3);
  EXPECT_EQ(call(folder, "db check --db " + db).code, 0);
  const Answer again = call(folder, "study " + file + " --db " + db);
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.out, ContainsRegex(std::to_string(12 - kept) + " cases? run, " + std::to_string(kept) + " taken"));
}

void insert_behind(std::string& text, const std::string& place, const std::string& more) {
  text.insert(text.find(place) + place.size(), more);
}

TEST(StudyCommand, ANormIsAskedOfTheSeriesThatTheFitNames) {
  const Folder folder;
  std::string text = small_study;
  insert_behind(text, "basis = \"bspline2\"\n", "every_step = true\n");
  insert_behind(text, "window = [8, 64]\n",
                "[[fit]]\nnorm = \"l2_all_steps\"\nseries = [\"bspline2\"]\nwindow = [8, 64]\n");
  const Answer answer = call(folder, "study " + folder.write("small.toml", text) + " --db " + folder / "r.db");
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("l2_all_steps"));
}

TEST(StudyCommand, AFitOfAllSeriesLeavesOutThoseThatDoWithoutItsNorm) {
  const Folder folder;
  std::string text = small_study;
  insert_behind(text, "ppc = 4\n", "every_step = true\n");
  insert_behind(text, "basis = \"linear\"\n", "every_step = false\n");
  insert_behind(text, "window = [8, 64]\n", "[[fit]]\nnorm = \"l2_all_steps\"\nwindow = [8, 64]\n");
  const std::string study = "study --db " + (folder / "r.db") + " ";
  const Answer answer = call(folder, study + folder.write("small.toml", text));
  EXPECT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, ContainsRegex("bspline2 +l2_all_steps"));
  EXPECT_THAT(answer.out, Not(ContainsRegex("linear +l2_all_steps")));
  insert_behind(text, "norm = \"l2_all_steps\"\n", "series = [\"linear\"]\n");
  const Answer named = call(folder, study + folder.write("small.toml", text));
  EXPECT_EQ(named.code, 2);
  EXPECT_THAT(named.err, HasSubstr("without every_step = true in series 'linear'"));
}

}  // namespace mpmvv::cli::study_test
