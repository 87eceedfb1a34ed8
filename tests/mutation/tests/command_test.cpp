#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"
#include "tests/mutation/results.hpp"

namespace mpmvv::mutation::mutants_test {

namespace fs = std::filesystem;
using cli::Answer;
using cli::call;
using cli::Folder;
using cli::read_text;
using cli::shell;
using testing::HasSubstr;

const std::string tree = std::string(" --source '") + MPMVV_SOURCE_DIR + "'";

TEST(MutantsCommand, ListsThePlantedMistakes) {
  const Folder folder;
  const auto mistakes = call(folder, "--list --json" + tree).json()["mistakes"];
  EXPECT_GE(mistakes.size(), 45U);
  for (const auto& mistake : mistakes) EXPECT_FALSE(mistake["what"].get<std::string>().empty());
}

TEST(MutantsCommand, ListsThemInAHundredColumns) {
  const Folder folder;
  std::istringstream lines(call(folder, "--list" + tree).out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 100U) << line;
  EXPECT_GE(count, 90);
}

TEST(MutantsCommand, BadInputIsNamed) {
  const Folder folder;
  const auto complaint = [&folder](const std::string& options) {
    const Answer answer = call(folder, options);
    EXPECT_EQ(answer.code, 2) << options;
    EXPECT_THAT(answer.err, testing::StartsWith("mutation_campaign: "));
    return answer.err;
  };
  const std::string results = " --results '" + (folder / "m.json") + "' --work '" + (folder / "work") + "'";
  EXPECT_THAT(complaint(tree), HasSubstr("no --results given"));
  EXPECT_THAT(complaint(results + " --source '" + (folder / "none") + "'"), HasSubstr("planted.toml"));
  EXPECT_THAT(complaint(results + " --random -1" + tree), HasSubstr("--random"));
  EXPECT_THAT(complaint(results + " --publish --only hat-without-its-far-node" + tree), HasSubstr("--only"));
  EXPECT_THAT(complaint("--results m.json --work ''"), HasSubstr("--work: an empty text"));
  EXPECT_THAT(complaint("--list=yes"), HasSubstr("(true or false)"));
  EXPECT_FALSE(fs::exists(folder / "m.json"));
}

/// What a campaign needs is looked for before anything is made.
TEST(MutantsCommand, WritesNothingWhereItCannotBegin) {
  const Folder folder;
  const auto complaint = [&](const std::string& results) {
    const Answer answer = call(folder, "--results '" + results + "' --work '" + (folder / "work") + "'" + tree);
    EXPECT_EQ(answer.code, 2);
    EXPECT_FALSE(fs::exists(results)) << results;
    EXPECT_FALSE(fs::exists(folder / "work"));
    return answer.err;
  };
  EXPECT_THAT(complaint(folder / "none/m.json"), HasSubstr("none' that may be written for results"));
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  EXPECT_THAT(complaint(folder / "m.json"), HasSubstr("no program 'cmake'"));
  setenv("PATH", path.c_str(), 1);

  fs::create_directories(folder / "mine/tree");
  folder.write("mine/tree/notes", "mine");
  EXPECT_THAT(call(folder, "--results '" + (folder / "m.json") + "' --work '" + (folder / "mine") + "'" + tree).err,
              HasSubstr("neither empty nor a scratch folder"));
  EXPECT_EQ(read_text(folder / "mine/tree/notes"), "mine");
  EXPECT_FALSE(fs::exists(folder / "m.json"));
}

/// What is no campaign's file stays as it is.
TEST(MutantsCommand, TakesNoOtherFileForItsResults) {
  const Folder folder;
  for (const char* text : {"{}", "[[mistake]]", ""}) {
    const std::string file = folder.write("other", text);
    const Answer answer = call(folder, "--results '" + file + "' --work '" + (folder / "work") + "'" + tree);
    EXPECT_EQ(answer.code, 2);
    EXPECT_THAT(answer.err, HasSubstr(file));
    EXPECT_EQ(read_text(file), text);
  }
}

TEST(MutantsCommand, APathOfAnyKindIsTakenOrRefusedInOneLine) {
  const Folder folder;
  folder.write("file", "x\n");
  fs::create_directories(folder / "empty");
  ASSERT_EQ(shell("mkfifo '" + (folder / "pipe") + "'").code, 0);
  for (const std::string option : {"--known --results ", "--list --source "})
    for (const std::string& path :
         std::vector<std::string>{"absent/x", "empty", "file", "file/x", "pipe", "/dev/full", "''",
                                  std::string(300, 'x'), "'\xff\xfe'", "'a\033]0;\nb'"}) {
      const Answer answer = call(folder, option + path, "cd '" + (folder / "") + "' && ");
      EXPECT_TRUE(answer.code >= 0 && answer.code <= 3) << option << path << answer.code;
      if (answer.code == 2) {
        EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
      }
      EXPECT_EQ(answer.err.find('\033'), std::string::npos) << option << path;
      for (const char* word : {"std::", "json.exception", "filesystem error", "terminate"})
        EXPECT_EQ(answer.err.find(word), std::string::npos) << option << path << answer.err;
    }
}

/// A tree with a source, and lists of which one mistake and one explanation are not of it.
TEST(MutantsCommand, WhatTheSourcesDoNotMatchIsListed) {
  const Folder folder;
  fs::create_directories(folder / "tests/mutation");
  fs::create_directories(folder / "solver/basis");
  folder.write("solver/basis/a.hpp", "inline int f(int x, int y) {\n  return x + 2 * y;\n}\n");
  const std::string mistake = "[[mistake]]\nname = \"NAME\"\nwhat = \"w\"\nfile = \"a.hpp\"\nreplace = \"0\"\n";
  const auto named = [&](const std::string& name) { return std::string(mistake).replace(20, 4, name); };
  folder.write("tests/mutation/planted.toml",
               named("good") + "find = \"x + 2 * y\"\n" + named("moved") + "find = \"return z + 2 * y;\"\n");
  folder.write("tests/mutation/explained.toml",
               "[[survivor]]\nfile = \"a.hpp\"\nbefore = \"return x + 3;\"\nafter = \"x - 3\"\nreason = \"r\"\n");
  const std::string source = " --source '" + (folder / "") + "'";
  const Answer answer = call(folder, "--check" + source);
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.out, HasSubstr("'find' of mistake 'moved' occurs nowhere in solver/basis/a.hpp in "));
  EXPECT_THAT(answer.out, HasSubstr("planted.toml:7 (code that occurs there exactly once)\n    solver/basis/a.hpp:2 "
                                    "differs in 1 of 7 tokens: return x + 2 * y;\n"));
  EXPECT_THAT(answer.out, HasSubstr("no mutation of a.hpp makes 'x - 3' of 'return x + 3;' in "));
  EXPECT_THAT(answer.err, HasSubstr("2 of 3 entries do not match the sources"));

  const Answer campaign = call(folder, "--results '" + (folder / "m.json") + "'" + source);
  EXPECT_EQ(campaign.code, 2);
  EXPECT_THAT(campaign.err, HasSubstr("'moved' occurs nowhere"));
  EXPECT_THAT(campaign.err, HasSubstr("; --check lists 1 more\n"));
  EXPECT_EQ(std::count(campaign.err.begin(), campaign.err.end(), '\n'), 1);
  EXPECT_FALSE(fs::exists(folder / "m.json"));
  EXPECT_FALSE(fs::exists(folder / "build"));
}

/// Results with one planted mistake that the quick gate has caught, tried by this program.
class KnownMutants : public testing::Test {
 protected:
  KnownMutants() {
    fs::create_directories(folder_ / "tests/mutation");
    folder_.write(
        "tests/mutation/planted.toml",
        "[[mistake]]\nname = \"sign\"\nwhat = \"A sign.\"\nfile = \"a.hpp\"\nfind = \"+\"\nreplace = \"-\"\n"
        "[[mistake]]\nname = \"factor\"\nwhat = \"A factor.\"\nfile = \"a.hpp\"\nfind = \"2\"\nreplace = \"3\"\n");
    Mutant sign{.name = "sign", .what = "A sign.", .file = "a.hpp", .line = 1, .gate = "g"};
    sign.trials = {{GateStage::quick, true, {"s-fig10: order"}, 1}};
    folder_.write("m.json", to_json({known(folder_ / "none.json")["digest"], "c", {sign}}).dump());
  }

  /// What is printed of results and the lists beside them.
  nlohmann::json known(const std::string& results, const std::string& more = "--known") {
    return call(folder_, "--json --results '" + results + "' --source '" + (folder_ / "") + "' " + more).json();
  }

  Folder folder_;
  std::string results_ = folder_ / "m.json";
};

nlohmann::json named(const nlohmann::json& mutants, const std::string& name) {
  return *std::ranges::find(mutants, name, [](const nlohmann::json& m) { return m["name"].get<std::string>(); });
}

TEST_F(KnownMutants, ArePrintedAndNoneIsTried) {
  const auto mutants = known(results_)["mutants"];
  ASSERT_EQ(mutants.size(), 2U);
  EXPECT_TRUE(named(mutants, "sign")["quick"]["caught"]);
  EXPECT_TRUE(named(mutants, "sign")["unit_tests"].is_null());
  EXPECT_TRUE(named(mutants, "factor")["quick"].is_null());
}

TEST_F(KnownMutants, NoneIsMissing) {
  const Answer answer =
      call(folder_, "--json --known --results '" + (folder_ / "empty.json") + "' --source '" + (folder_ / "") + "'");
  EXPECT_EQ(answer.code, 3);
  EXPECT_EQ(answer.json()["mutants"].size(), 0U);
  EXPECT_THAT(answer.err, HasSubstr("empty.json knows no mutant of this program"));
  EXPECT_FALSE(fs::exists(folder_ / "empty.json"));
}

/// The report reads the summary: see tests/cli.
TEST_F(KnownMutants, PublishedOnesCountWithoutAStore) {
  for (const char* time : {"the first", "the second"}) {
    EXPECT_EQ(known(results_, "--publish")["mutants"].size(), 2U) << time;
    const auto summary = nlohmann::json::parse(read_text(folder_ / "tests/mutation/summary.json"));
    EXPECT_EQ(summary["planted"]["quick"], 1) << time;
    EXPECT_EQ(summary["planted"]["should_show"], 2) << time;
    EXPECT_EQ(summary["planted"]["untried"], 1) << time;
    EXPECT_FALSE(summary.contains("mutants")) << time;
  }
}

}  // namespace mpmvv::mutation::mutants_test
