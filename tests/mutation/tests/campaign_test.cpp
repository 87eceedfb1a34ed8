#include "tests/mutation/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "studies/support/error.hpp"
#include "tests/mutation/scratch_tree.hpp"

namespace mpmvv::mutation::mutant_campaign_test {

using support::UsageError;

namespace fs = std::filesystem;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

/// A gate that catches by name.
class FakeBench final : public Bench {
 public:
  bool build(const Edit* edit) override {
    edit_ = edit ? edit->file : "";
    return !broken.contains(edit_);
  }
  Trial meet(GateStage stage, seconds limit) override {
    log.push_back(edit_ + " " + to_string(stage));
    limits.push_back(limit);
    const auto found = catches.find(edit_);
    const bool caught = found != catches.end() && found->second == stage;
    return {stage, caught, caught ? std::vector<std::string>{"golden"} : std::vector<std::string>{}, 2};
  }
  std::string complaint() const override { return "no compiler"; }

  std::map<std::string, GateStage> catches;
  std::set<std::string> broken;
  std::vector<std::string> log;
  std::vector<seconds> limits;

 private:
  std::string edit_;
};

Candidate candidate(const std::string& name, Mutant::Kind kind) {
  Candidate c;
  c.mutant.name = c.mutant.file = c.edit.file = name;
  c.mutant.kind = kind;
  c.mutant.gate = "gate";
  return c;
}

class Campaigns : public testing::Test {
 protected:
  std::vector<Mutant> run(const CampaignPlan& plan) {
    const std::vector<Mutant> known = kept_;
    return run_campaign(plan, gate_, bench_,
                        {.find = [&](const Mutant& wanted) { return known_result(known, wanted); },
                         .keep =
                             [&](const Mutant& mutant) {
                               std::erase_if(kept_, [&](const Mutant& m) { return m.name == mutant.name; });
                               kept_.push_back(mutant);
                             },
                         .tell = [](const std::string&) {}});
  }

  std::string gate_ = "gate";
  FakeBench bench_;
  std::vector<Mutant> kept_;
  const Candidate planted_ = candidate("p", Mutant::Kind::planted), silent_ = candidate("q", Mutant::Kind::planted);
  const Candidate first_ = candidate("r1", Mutant::Kind::random), second_ = candidate("r2", Mutant::Kind::random),
                  third_ = candidate("r3", Mutant::Kind::random);
};

TEST_F(Campaigns, StagesComeInTheirOrderAndTheUnchangedTreeFirst) {
  bench_.catches = {{"p", GateStage::unit_tests}, {"r1", GateStage::quick}, {"r2", GateStage::unit_tests}};
  const auto results = run({{planted_, silent_}, {first_, second_, third_}, 2});
  EXPECT_THAT(bench_.log, ElementsAre(" unit tests", " quick", "p unit tests", "p quick", "q unit tests", "q quick",
                                      "r1 quick", "r2 quick", "r2 unit tests", " nightly", "q nightly"));
  ASSERT_EQ(results.size(), 5U);
  EXPECT_EQ(results[0].name, "baseline");
  EXPECT_TRUE(results[1].caught_by(GateStage::unit_tests));
  EXPECT_FALSE(results[2].caught());
  EXPECT_THAT(bench_.limits, testing::Contains(seconds(130))) << "several times the unchanged tree's 2 s";
}

TEST_F(Campaigns, WhatIsExplainedDoesNotMeetTheNightlyGate) {
  Candidate explained = first_;
  explained.mutant.reason = "equivalent";
  const auto results = run({{}, {explained, second_}, 2});
  EXPECT_THAT(bench_.log, ElementsAre(" quick", " unit tests", "r1 quick", "r1 unit tests", "r2 quick", "r2 unit tests",
                                      " nightly", "r2 nightly"));
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(results[1].reason, "equivalent");
}

TEST_F(Campaigns, WhatDoesNotCompileIsNoMutant) {
  bench_.broken = {"r1"};
  bench_.catches = {{"r2", GateStage::quick}};
  const auto results = run({{}, {first_, second_, third_}, 1});
  ASSERT_EQ(results.size(), 3U);
  EXPECT_FALSE(results[1].builds);
  EXPECT_EQ(results[2].name, "r2");
}

TEST_F(Campaigns, WhatIsKnownIsNotDoneAgain) {
  bench_.catches = {{"p", GateStage::quick}};
  run({{planted_}, {}, 0});
  bench_.log.clear();
  EXPECT_EQ(run({{planted_}, {}, 0}).size(), 2U);
  EXPECT_THAT(bench_.log, testing::IsEmpty());

  kept_.back().trials.pop_back();  // as if killed between two stages
  run({{planted_}, {}, 0});
  EXPECT_THAT(bench_.log, testing::Contains("p quick"));
  EXPECT_THAT(bench_.log, testing::Not(testing::Contains("p unit tests")));
}

TEST_F(Campaigns, WhatIsNotKnownIsToBeTried) {
  bench_.catches = {{"p", GateStage::quick}, {"r1", GateStage::quick}};
  const CampaignPlan plan{{planted_, silent_}, {first_, second_, third_}, 2};
  const auto find = [this](const Mutant& wanted) { return known_result(kept_, wanted); };
  EXPECT_THAT(edits_to_try(plan, find), ElementsAre(planted_.edit, silent_.edit, first_.edit, second_.edit));
  run({{planted_}, {first_}, 1});
  EXPECT_THAT(edits_to_try(plan, find), ElementsAre(silent_.edit, second_.edit));
}

TEST_F(Campaigns, WhatHasBeenCaughtStaysCaughtWhileTheSourcesAreTheSame) {
  bench_.catches = {{"p", GateStage::quick}};
  const auto with_gate = [this](const std::string& gate) {
    Candidate p = planted_;
    p.mutant.gate = gate_ = gate;
    bench_.log.clear();
    return run({{p}, {}, 0});
  };
  with_gate("sources/tests");
  const auto results = with_gate("sources/more tests");
  EXPECT_THAT(bench_.log, ElementsAre(" unit tests", "p unit tests"));
  EXPECT_TRUE(results[1].caught_by(GateStage::quick));
  with_gate("sources/more tests");
  EXPECT_TRUE(bench_.log.empty()) << "what has passed the new tests has passed them";
  with_gate("other sources/more tests");
  EXPECT_THAT(bench_.log, testing::Contains("p quick"));
}

TEST_F(Campaigns, AGateThatFailsOnTheUnchangedTreeProvesNothing) {
  bench_.catches = {{"", GateStage::quick}};
  try {
    run({{planted_}, {}, 0});
    ADD_FAILURE();
  } catch (const support::UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("does not pass its quick: golden"));
  }
  bench_.broken = {""};
  EXPECT_THROW(run({{silent_}, {}, 0}), support::UsageError);
}

class ScratchTrees : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(source_ / "code/inner");
    write("code/a.txt", "one + two\n");
    write("code/inner/b.txt", "three\n");
    write("notes", "four\n");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& file, const std::string& text) const { std::ofstream(source_ / file) << text; }
  ScratchTree scratch() const { return ScratchTree(source_, folder_ / "work", {"code", "notes"}); }
  static std::string read(const fs::path& file) { return (std::stringstream() << std::ifstream(file).rdbuf()).str(); }

  fs::path folder_ = fs::temp_directory_path() /
                     (std::string("mpmvv_scratch_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
                      std::to_string(getpid()));
  fs::path source_ = folder_ / "source";
  const Edit edit_{"code/a.txt", 4, "+", "-"};
};

TEST_F(ScratchTrees, AnEditIsMadeInTheCopyAlone) {
  ScratchTree copy = scratch();
  EXPECT_THAT(copy.files(), ElementsAre("code/a.txt", "code/inner/b.txt", "notes"));
  copy.apply(edit_);
  EXPECT_EQ(copy.run({"cat", "code/a.txt"}, seconds(10)).output, "one - two\n");
  EXPECT_EQ(copy.text("code/a.txt"), "one + two\n");
  EXPECT_EQ(read(source_ / "code/a.txt"), "one + two\n");
  copy.apply({"notes", 0, "four", "five"});
  EXPECT_EQ(read(copy.tree() / "code/a.txt"), "one + two\n") << "one edit at a time";
  copy.undo();
  EXPECT_EQ(read(copy.tree() / "notes"), "four\n");
}

TEST_F(ScratchTrees, ManyFilesChangeTogetherAndNewOnesGo) {
  ScratchTree copy = scratch();
  copy.apply({{"code/a.txt", "six\n"}, {"code/new.txt", "seven\n"}});
  EXPECT_EQ(read(copy.tree() / "code/a.txt"), "six\n");
  EXPECT_EQ(read(copy.tree() / "code/new.txt"), "seven\n");
  EXPECT_EQ(copy.text("code/a.txt"), "one + two\n");
  copy.apply(edit_);
  EXPECT_EQ(read(copy.tree() / "code/a.txt"), "one - two\n");
  EXPECT_FALSE(fs::exists(copy.tree() / "code/new.txt"));
}

TEST_F(ScratchTrees, ANewOneUndoesWhatAKilledOneLeft) {
  scratch().apply(edit_);
  std::ofstream(folder_ / "work/tree/code/stray.txt") << "five";
  fs::create_directories(folder_ / "work/tree/build/mutants");
  std::ofstream(folder_ / "work/tree/build/mutants/built") << "six";
  fs::remove(source_ / "code/inner/b.txt");
  const ScratchTree copy = scratch();
  EXPECT_EQ(read(copy.tree() / "code/a.txt"), "one + two\n");
  EXPECT_FALSE(fs::exists(copy.tree() / "code/stray.txt"));
  EXPECT_FALSE(fs::exists(copy.tree() / "code/inner/b.txt"));
  EXPECT_EQ(read(copy.build() / "built"), "six");
}

TEST_F(ScratchTrees, TheDigestIsThatOfTheUneditedFiles) {
  ScratchTree copy = scratch();
  const auto but_notes = [](const std::string& file) { return !is_within(file, "notes"); };
  const std::string digest = copy.digest(but_notes);
  copy.apply(edit_);
  EXPECT_EQ(copy.digest(but_notes), digest);
  write("notes", "changed\n");
  EXPECT_EQ(scratch().digest(but_notes), digest);
  write("code/a.txt", "changed\n");
  EXPECT_NE(scratch().digest(but_notes), digest);
}

TEST_F(ScratchTrees, CommentsAndLayoutOfCodeDoNotChangeTheDigest) {
  const auto digest = [&](const std::string& code) {
    write("code/c.hpp", code);
    return scratch().digest([](const std::string& file) { return file == "code/c.hpp"; });
  };
  const std::string first = digest("/// Two.\nint a = 4 / 2;\n");
  EXPECT_EQ(digest("// One\n// \"half\" of four.\n\n  int a = 4 / 2;  // https://two\n"), first);
  EXPECT_NE(digest("int a = 4 / 3;\n"), first);
  EXPECT_NE(digest("const char* a = \"http://a\";\n"), digest("const char* a = \"http://b\";\n"));
  for (const char* before : {"/* // four */ ", "auto b = R\"(\n// )\"; ", "#define B \\\n//\n"})
    EXPECT_NE(digest(before + std::string("int a = 4;\n")), digest(before + std::string("int a = 5;\n"))) << before;
}

TEST_F(ScratchTrees, ProgramsOfTheTreeRunInTheCopy) {
  write("code/program", "#!/bin/sh\necho six\n");
  EXPECT_FALSE(scratch().run({"test", "-x", "code/program"}, seconds(10)).good());
  fs::permissions(source_ / "code/program", fs::perms::owner_exec, fs::perm_options::add);
  EXPECT_EQ(scratch().run({"./code/program"}, seconds(10)).output, "six\n") << "the one of before becomes a program";
}

TEST_F(ScratchTrees, WhatNeverEndsIsStopped) {
  EXPECT_TRUE(scratch().run({"sleep", "60"}, seconds(0)).timed_out);
  EXPECT_THROW(scratch().run({"./no-such-program"}, seconds(1)), support::UsageError);
}

TEST_F(ScratchTrees, OneProcessWorksThereAtATime) {
  const ScratchTree copy = scratch();
  EXPECT_EXIT(
      {
        try {
          scratch();
          std::exit(0);
        } catch (const support::UsageError&) {
          std::exit(3);
        }
      },
      testing::ExitedWithCode(3), "");
}

TEST_F(ScratchTrees, BadPlacesAreRefused) {
  EXPECT_THROW(ScratchTree(source_, folder_ / "work", {"absent"}), support::UsageError);
  EXPECT_THROW(ScratchTree(source_, source_ / "code/work", {"code"}), support::UsageError);
}

/// What is not the program's own stays as it is.
TEST_F(ScratchTrees, OnlyWhatIsEmptyOrItsOwnIsAScratchFolder) {
  const auto refuses = [&](const fs::path& work) {
    EXPECT_THROW(ScratchTree(source_, work, {"code", "notes"}), support::UsageError) << work;
  };
  const fs::path foreign = folder_ / "foreign", marker = folder_ / "work/mpmvv-scratch";
  fs::create_directories(foreign / "tree/code");
  std::ofstream(foreign / "tree/code/mine.txt") << "mine";
  std::ofstream(folder_ / "file") << "mine";
  for (const fs::path& work : {foreign, foreign / "tree/..", folder_ / "file", source_, source_ / ".", folder_})
    refuses(work);
  fs::create_directories(folder_ / "empty");
  for (const fs::path& work : {folder_ / "empty", source_ / "build/scratch"})
    EXPECT_NO_THROW(ScratchTree(source_, work, {"notes"}));
  fs::create_directory_symlink(foreign, folder_ / "link");
  refuses(folder_ / "link");
  scratch();
  fs::create_symlink(marker, foreign / marker.filename());
  refuses(foreign);
  fs::remove(foreign / marker.filename());
  std::ofstream(foreign / marker.filename()) << "mine";
  refuses(foreign);
  for (const char* inside : {"tree", "tree/code", "tree/build", "tree/build/mutants"}) {
    scratch();
    fs::remove_all(folder_ / "work" / inside);
    fs::create_directories((folder_ / "work" / inside).parent_path());
    fs::create_directory_symlink(foreign / "tree", folder_ / "work" / inside);
    refuses(folder_ / "work");
    fs::remove(folder_ / "work" / inside);
  }
  EXPECT_EQ(read(foreign / "tree/code/mine.txt"), "mine");
  EXPECT_EQ(read(foreign / marker.filename()), "mine");
  EXPECT_FALSE(fs::exists(foreign / "tree/notes"));
  EXPECT_FALSE(fs::exists(source_ / "tree")) << "nothing is begun in a folder that is refused";
}

}  // namespace mpmvv::mutation::mutant_campaign_test
