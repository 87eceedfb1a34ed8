#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "studies/store/store.hpp"
#include "tests/cli/program.hpp"
#include "tests/cli/small_store.hpp"

namespace mpmvv::cli::gate_text_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

/// Goldens of which one passes, one fails, one is inconclusive, and two are of studies that nobody has run.
class GateText : public testing::Test {
 protected:
  void SetUp() override {
    unsetenv("GITHUB_ACTIONS");  // set where GitHub runs these tests, and then the gate prints annotations, too
    std::filesystem::create_directories(folder_ / "goldens");
    golden("small",
           "[[status]]\nseries = \"linear\"\nat = 8\nexpected = \"ok\"\n"
           "[[status]]\nseries = \"linear\"\nat = 16\nexpected = \"unstable\"\n"
           "[[status]]\nseries = \"linear\"\nat = 99\nexpected = \"ok\"\n");
    for (const char* other : {"one", "two"}) golden(other, "[[status]]\nseries = \"s\"\nat = 1\nexpected = \"ok\"\n");
  }

  Answer gate(const std::string& options = "") {
    return call(folder_, "gate --db " + db_ + " --goldens " + (folder_ / "goldens") + " " + options);
  }

  /// Keeps a study of one series that this version of a code ran.
  void keep(const std::string& name, const std::string& version, const std::string& digest, const std::string& day) {
    records::StudyResult study;
    study.name = name, study.sweep = "cells";
    study.series = {{"theirs", {{8, records::Status::ok, "", {{"l2", 0.1}}}}, {}, {}}};
    study.series[0].code = records::OtherCode{"my-code", version, "", "reference", digest};
    const store::Provenance p{
        own_digest(folder_), "c0ffee", false, "GNU 12.2.0", "-O3", "Release", "CPU", "2026-01-" + day + "T00:00:00Z"};
    store::Store(db_, store::Store::Mode::create_or_write).keep_study(study, {}, p);
  }

  Folder folder_;

 private:
  void golden(const std::string& study, const std::string& expectations) {
    folder_.write("goldens/" + study + ".toml", "reviewed = \"now\"\nstudy = \"" + study + "\"\n" + expectations);
  }

  std::string db_ = store_of(folder_);
};

TEST_F(GateText, WhatFailsComesFirstAndWhatPassesIsCounted) {
  const Answer answer = gate();
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.out, MatchesRegex("verdict +study +golden\n"
                                       "fail +small +status of 'linear' at 16: expected unstable, measured ok .*\n"
                                       "inconclusive +small +status of 'linear' at 99: .*\n"
                                       "nothing in the store for 2 goldens of 2 studies: one \\(1\\), two \\(1\\) "
                                       "\\(--only STUDY judges one\\)\n"
                                       "gate: 1 pass, 1 fail, 3 inconclusive\n"));
  EXPECT_THAT(gate("--json").json()["results"][4]["absent"], true);
}

TEST_F(GateText, WhereNothingWasRunThereIsNoStudyToJudgeAlone) {
  EXPECT_THAT(gate("--only one").out, AllOf(HasSubstr("for 1 golden of 1 study: one (1)\n"), Not(HasSubstr("--only"))));
}

TEST_F(GateText, VerboseNamesEachGolden) {
  const Answer answer = gate("--verbose");
  EXPECT_THAT(answer.out, AllOf(HasSubstr("status of 'linear' at 8: expected ok, measured ok\n"),
                                HasSubstr("no study 'one' in the store"), HasSubstr("no study 'two' in the store"),
                                Not(HasSubstr("nothing in the store"))));
}

TEST_F(GateText, NamesTheVersionsOfCodesWhoseGoldensAreJudged) {
  for (const char* other : {"two", "cost", "limit"}) keep(other, "1.4", "aa11", "01");
  EXPECT_THAT(gate().out, HasSubstr("judged: my-code 1.4 in two, of 2026-01-01T00:00:00Z\nno goldens of: cost, limit\n"
                                    "gate: "));
  EXPECT_THAT(gate("--only two").out, Not(HasSubstr("no goldens of")));
  EXPECT_THAT(gate("--only one").out, Not(HasSubstr("judged")));
  keep("two", "1.4", "bb22", "02");
  EXPECT_THAT(gate().out, HasSubstr("judged: my-code 1.4 (digest bb22) in two, of 2026-01-02T00:00:00Z\n"))
      << "two programs of one version";
  const auto codes = gate("--json").json()["codes"];
  ASSERT_EQ(codes.size(), 1U);
  EXPECT_EQ(codes[0]["digest"], "bb22");
}

TEST_F(GateText, AnnotatesForGithub) {
  const std::string mark = "::error file=" + (folder_ / "goldens/small.toml") + ",line=7,title=small%3A status";
  EXPECT_THAT(gate("--github").out, AllOf(HasSubstr("1 pass, 1 fail"), HasSubstr(mark)));
  EXPECT_EQ(gate("--github --json").code, 2);
  setenv("GITHUB_ACTIONS", "true", 1);
  EXPECT_THAT(gate().out, HasSubstr(mark));
  EXPECT_EQ(gate("--json").json()["fail"], 1);
  unsetenv("GITHUB_ACTIONS");
  EXPECT_THAT(gate().out, Not(HasSubstr("::error")));
}

}  // namespace mpmvv::cli::gate_text_test
