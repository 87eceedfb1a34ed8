#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "cli/lines.hpp"
#include "studies/store/store.hpp"
#include "studies/store/trial.hpp"
#include "tests/cli/program.hpp"

namespace mpmvv::cli::history_test {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

records::StudyResult bar_study(double order, double finest) {
  records::StudyResult study;
  study.name = "bar";
  study.kind = records::StudyKind::convergence;
  study.sweep = "cells";
  records::Series series{"linear", {}, {}, {}};
  series.points = {{8, records::Status::ok, "", {{"l2", 1e-2}}}, {16, records::Status::ok, "", {{"l2", finest}}}};
  series.orders.resize(1);
  series.orders[0].norm = "l2";
  series.orders[0].from = 8;
  series.orders[0].to = 16;
  series.orders[0].points = 2;
  series.orders[0].order = order;
  study.series = {series};
  study.values = {{"gap", 1, ""}};
  return study;
}

void keep(const std::string& db, const records::StudyResult& study, const std::string& digest,
          const std::string& commit, const std::string& time) {
  const store::Provenance p{digest, commit, false, "GNU 12.2.0", "-O3", "Release", "CPU", time};
  store::Store(db, store::Store::Mode::create_or_write).keep_study(study, {}, p);
}

/// Two versions in one store: the order drops, the finest error grows.
class History : public testing::Test {
 protected:
  void SetUp() override {
    keep(db_, bar_study(2, 2.5e-3), "00ff11", "c0ffee", "2026-01-01T00:00:00Z");
    keep(db_, bar_study(1, 5e-3), "00aa22", "c0de00", "2026-01-02T00:00:00Z");
  }

  Answer ask(const std::string& arguments) { return call(folder_, arguments + " --db " + db_); }

  Folder folder_;
  std::string db_ = folder_ / "r.db";
};

TEST_F(History, ATrialIsNoEvidenceOfAVersion) {
  records::StudyResult trial = bar_study(1, 5e-3);
  trial.text = store::with_trial("", "ppc = 4 in 1 of 1 series");
  keep(db_, trial, "00aa22", "c0de00", "2026-01-03T00:00:00Z");
  EXPECT_EQ(ask("compare c0f c0d --json").json()["compared"], 0);
  EXPECT_EQ(ask("trend --json").json()["trends"][0]["values"], nlohmann::json::parse("[2.0, null]"));
}

TEST_F(History, CompareShowsWhatChangedWorstFirst) {
  const Answer answer = ask("compare c0f c0d");
  ASSERT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, AllOf(HasSubstr("from c0ffee (digest 00ff11)"), HasSubstr("to   c0de00 (digest 00aa22)"),
                                HasSubstr("order of 'linear' in l2 over [8, 16]: 2 -> 1 (-1)"),
                                HasSubstr("error of 'linear' in l2: 0.0025 at 16 -> 0.005 at 16 (+100 %)"),
                                HasSubstr("2 of 5 results changed by more than round-off"), Not(HasSubstr("gap"))));
  EXPECT_LT(answer.out.find("error of"), answer.out.find("order of")) << "ten bands before less than seven";
  EXPECT_THAT(ask("compare c0f c0d --all").out, HasSubstr("value 'gap': 1 -> 1"));
  EXPECT_THAT(answer.out, Not(HasSubstr("one version")));
  EXPECT_THAT(ask("compare c0f c0f").out, HasSubstr("both are one version"));
}

TEST_F(History, FitsANarrowTerminal) {
  const std::string digest(16, 'd'), commit(12, 'c');
  keep(db_, bar_study(1, 5e-3), digest, commit, "2026-01-03T00:00:00Z");
  for (const int columns : {40, 60})
    for (const std::string command : {"trend", "compare c0f ccc", "compare ccc ccc"}) {
      std::istringstream lines(on_terminal(folder_, columns, command + " --db r.db"));
      for (std::string line; std::getline(lines, line);)
        EXPECT_LE(columns_of(line), static_cast<std::size_t>(columns)) << command << ": " << line;
    }
}

TEST_F(History, CompareAsJson) {
  const auto json = ask("compare 00ff 00aa --json").json();
  EXPECT_EQ(json["from"]["commits"][0], "c0ffee");
  EXPECT_EQ(json["compared"], 5);
  ASSERT_EQ(json["changes"].size(), 2U);
  EXPECT_EQ(json["changes"][0]["kind"], "error");
  EXPECT_EQ(json["changes"][0]["at"]["after"], 16);
  EXPECT_EQ(json["changes"][0]["largest"]["after"], 5e-3);
  EXPECT_EQ(json["changes"][1]["before"], 2);
}

records::StudyResult limit_study(double unstable, bool monotone) {
  records::StudyResult study;
  study.name = "steps";
  study.kind = records::StudyKind::limit;
  study.sweep = "cells";
  study.series = {{"linear", {}, {}, fits::StabilityLimit{"cfl", 0.8, unstable, monotone, true, {}}}};
  return study;
}

TEST_F(History, CompareSaysOfALimitThatItIsNotMonotone) {
  keep(db_, limit_study(0.82, true), "00ff11", "c0ffee", "2026-01-01T00:00:00Z");
  keep(db_, limit_study(0.9, false), "00aa22", "c0de00", "2026-01-02T00:00:00Z");
  EXPECT_THAT(ask("compare c0f c0d").out, HasSubstr("cfl limit of 'linear': 0.81 -> 0.85, not monotone (+4.94 %)\n"));
  const auto changes = ask("compare c0f c0d --json").json()["changes"];
  const auto limit = std::ranges::find_if(changes, [](const auto& change) { return change["kind"] == "limit"; });
  ASSERT_NE(limit, changes.end());
  EXPECT_EQ((*limit)["monotone"], nlohmann::json::parse(R"({"before": true, "after": false})"));
  EXPECT_FALSE(changes[0].contains("monotone")) << "an error";
}

records::StudyResult curve_check(double at_one) {
  records::StudyResult study;
  study.name = "laws";
  study.kind = records::StudyKind::check;
  study.series = {
      {"a", {{0, records::Status::ok, "", {{"y", 0}}}, {1, records::Status::ok, "", {{"y", at_one}}}}, {}, {}}};
  study.figures.resize(1);
  study.figures[0].name = "laws", study.figures[0].quantity = "y";
  return study;
}

TEST_F(History, OfACurveCompareSaysWhereItChangedMost) {
  keep(db_, curve_check(1), "00ff11", "c0ffee", "2026-01-01T00:00:00Z");
  keep(db_, curve_check(2), "00aa22", "c0de00", "2026-01-02T00:00:00Z");
  EXPECT_THAT(ask("compare c0f c0d").out, HasSubstr(" curve 'a' of y: most at 1: 1 -> 2\n"));
  EXPECT_THAT(ask("compare c0f c0f --all").out, HasSubstr(" curve 'a' of y: the same where both have it\n"));
  const auto change = ask("compare c0f c0d --json").json()["changes"][2];
  EXPECT_EQ(change["name"], "curve 'a' of y");
  EXPECT_EQ(change["largest"], nlohmann::json::parse(R"({"x": 1.0, "before": 1.0, "after": 2.0})"));
  EXPECT_FALSE(change.contains("before") || change.contains("after")) << "it has no number of its own";
  keep(db_, curve_check(1 + 2e-9), "00aa22", "c0de00", "2026-01-03T00:00:00Z");
  EXPECT_THAT(ask("compare c0f c0d").out, HasSubstr(": most at 1: 1 -> 1.000000002\n")) << "digits enough to see it";
}

TEST_F(History, AVersionAgainstItselfIsUnchanged) {
  const auto json = ask("compare c0ffee c0ffee --json").json();
  EXPECT_EQ(json["changed"], 0);
  EXPECT_TRUE(json["changes"].empty());
}

TEST_F(History, VersionsThatAreNoneOrTwoAreRefused) {
  for (const char* bad : {"compare c0 c0ffee", "compare dead c0ffee", "compare c0ffee"}) {
    const Answer answer = ask(bad);
    EXPECT_EQ(answer.code, 2) << bad;
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    EXPECT_THAT(answer.err, AllOf(HasSubstr("c0ffee (digest 00ff11)"), HasSubstr("c0de00 (digest 00aa22)"))) << bad;
  }
  EXPECT_EQ(ask("compare").code, 2);
  EXPECT_EQ(call(folder_, "compare a b --db " + (folder_ / "absent.db")).code, 2);
}

TEST_F(History, OfAStoreWithoutStudiesThereIsNone) {
  const std::string db = folder_ / "empty.db";
  { const store::Store made(db, store::Store::Mode::create_or_write); }
  const Answer answer = call(folder_, "trend --db " + db);
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(answer.err, "mpmvv: " + db + " holds no study of mpmvv (run `mpmvv study` first)\n");
}

TEST_F(History, TrendFollowsTheTime) {
  const auto json = ask("trend --json").json();
  EXPECT_EQ(json["versions"][0]["digest"], "00ff11");
  ASSERT_EQ(json["trends"].size(), 3U);
  EXPECT_EQ(json["trends"][0]["values"], nlohmann::json::parse("[2.0, 1.0]"));
  EXPECT_EQ(json["trends"][1]["unit"], "m");
  EXPECT_FALSE(json["trends"][0].contains("unit")) << "an order";
  const Answer answer = ask("trend");
  EXPECT_THAT(
      answer.out,
      AllOf(StartsWith("  1  c0ffee (digest 00ff11)"),
            ContainsRegex(
                "\n +version +version\nstudy +1 +2 +result\nbar +2 +1 +order of 'linear' in l2 over .8, 16.\n")));
}

TEST_F(History, TrendSaysWhichNumbersRestOnRunsThatAreNotOk) {
  records::StudyResult broken = bar_study(1.5, support::not_measured);
  broken.series[0].points[1].status = records::Status::unstable;
  keep(db_, broken, "00cc33", "badbad", "2026-01-03T00:00:00Z");
  const auto trends = ask("trend --json").json()["trends"];
  EXPECT_EQ(trends[0]["remarks"], nlohmann::json::parse(R"(["", "", "unstable"])"));
  EXPECT_EQ(trends[1]["at"], 16);
  EXPECT_EQ(trends[1]["remarks"][2], "unstable");
  EXPECT_FALSE(trends.back().contains("remarks"));
  EXPECT_THAT(ask("trend").out, AllOf(ContainsRegex("\nbar +2 +1 +1[.]5\\* +order of"),
                                      ContainsRegex("unstable +error of 'linear' in l2 .m. at 16\n"),
                                      HasSubstr("* of runs that are not all ok: some are unstable or failed")));
}

/// A series that another code ran, and one of ours.
void keep_of_code(const std::string& db, const std::string& version, const std::string& digest, double order) {
  records::StudyResult study = bar_study(order, 2.5e-3);
  study.series[0].code = records::OtherCode{"my-code", version, "", "reference", digest};
  study.series.push_back(bar_study(2, 1e-3).series[0]);
  study.series[1].name = "ours";
  const store::Provenance p{"00aa22", "c0de00",  false, "GNU 12.2.0",
                            "-O3",    "Release", "CPU", "2026-02-0" + version.substr(2) + "T00:00:00Z"};
  store::Store(db, store::Store::Mode::create_or_write).keep_study(study, {}, p);
}

TEST_F(History, WhatAnotherCodeRanIsNoEvidenceOfOurVersions) {
  records::StudyResult mixed = bar_study(1, 5e-3), theirs = bar_study(2, 1e-3);
  theirs.series[0].name = "theirs", theirs.series[0].code = records::OtherCode{"my-code", "1.3", "", "reference", "aa"};
  mixed.series.push_back(theirs.series[0]);
  for (const char* series : {"linear", "theirs"}) {
    const std::string found = std::string("order of '") + series + "' in l2";
    records::ClaimPart part{"T-a", std::string("order of ") + series, records::PartVerdict::holds, found + " = 1", ""};
    part.found = {{found, 1}};
    mixed.parts.push_back(part), theirs.parts = {part};
  }
  theirs.name = "theirs", theirs.claims = {"T-b"}, theirs.parts[0].claim = "T-b", mixed.claims = {"T-a"};
  for (const auto& [digest, commit, day] : {std::tuple{"00ff11", "c0ffee", "3"}, {"00aa22", "c0de00", "4"}})
    for (const auto& study : {mixed, theirs})
      keep(db_, study, digest, commit, std::string("2026-01-0") + day + "T00:00:00Z");
  const Answer answer = ask("compare c0f c0d --all");
  EXPECT_THAT(answer.out, AllOf(HasSubstr("criterion of T-a: order of linear"), HasSubstr("claim T-a")));
  EXPECT_THAT(answer.out, AllOf(Not(HasSubstr("order of theirs")), Not(HasSubstr("T-b"))));
}

TEST_F(History, VersionsOfAnotherCode) {
  for (const auto& [version, digest, order] :
       {std::tuple{"1.3", "aa11", 2.0}, {"1.4", "bb22", 1.0}, {"1.5", "cc33", 2.0}})
    keep_of_code(db_, version, digest, order);
  const auto trends = ask("trend --code my-code --json").json();
  EXPECT_EQ(trends["versions"][1]["version"], "1.4");
  ASSERT_EQ(trends["trends"].size(), 2U) << "order and error of the series that it ran";
  EXPECT_EQ(trends["trends"][0]["values"], nlohmann::json::parse("[2.0, 1.0, 2.0]"));
  EXPECT_THAT(ask("trend --code my-code").out, StartsWith("  1  1.3 (digest aa11)"));
  EXPECT_THAT(ask("compare 1.3 1.4 --code my-code").out,
              AllOf(HasSubstr("from 1.3 (digest aa11)"), HasSubstr("2 -> 1 (-1)"), Not(HasSubstr("ours"))));
  EXPECT_EQ(ask("compare 1.3 --code my-code --json").json()["changed"], 0) << "against the newest";
  EXPECT_EQ(ask("compare 1.3 --code my-code --json").json()["to"]["version"], "1.5");
  keep_of_code(db_, "1.6", "cc33", 1.0);
  EXPECT_EQ(ask("compare 1.5 --code my-code --json").json()["changed"], 1) << "another version of the same file";
  EXPECT_THAT(ask("compare 1.5 1.6 --code my-code").out, Not(HasSubstr("one version")));
  const auto codes = ask("db info --json").json()["codes"];
  ASSERT_EQ(codes.size(), 1U);
  EXPECT_EQ(codes[0]["code"], "my-code");
  EXPECT_EQ(codes[0]["versions"][1]["version"], "1.4");
  EXPECT_THAT(ask("db info").out, ContainsRegex("code my-code\n +1[.]3 [(]digest aa11[)], last study 2026-02-03T"));
  EXPECT_THAT(ask("compare 2.0 --code my-code").err,
              HasSubstr("no results of a version '2.0' of my-code (there are: "));
  const Answer answer = ask("trend --code other");
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.err, HasSubstr("of other codes: my-code"));
}

/// The words of the front door that the workflow calls.
TEST(Workflow, RunsWordsThatThereAre) {
  const std::string workflow = read_text(MPMVV_SOURCE_DIR "/.github/workflows/nightly.yml");
  const std::string door = read_text(MPMVV_SOURCE_DIR "/run");
  int calls = 0;
  for (auto at = workflow.find("./run "); at != std::string::npos; at = workflow.find("./run ", at + 1)) {
    const auto word = workflow.substr(at + 6, workflow.find_first_of(" \n", at + 6) - at - 6);
    EXPECT_THAT(door, HasSubstr("\n  " + word + " ")) << word;
    ++calls;
  }
  EXPECT_EQ(calls, 6);
  EXPECT_THAT(workflow, Not(HasSubstr("\t")));
  for (const char* kept : {"results/nightly.db", "results/report", "results/gate.xml", "results/quick.xml"}) {
    EXPECT_THAT(workflow, HasSubstr(kept));
    EXPECT_THAT(door, HasSubstr(kept));
  }
}

}  // namespace mpmvv::cli::history_test
