#include "tests/mutation/scratch_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "studies/support/error.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::mutation::scratch_tree_test {

using support::UsageError;

namespace fs = std::filesystem;
using std::chrono::seconds;
using testing::ElementsAre;

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

  fs::path folder_ = own_folder("scratch");
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

}  // namespace mpmvv::mutation::scratch_tree_test
