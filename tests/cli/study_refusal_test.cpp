#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/cli/program.hpp"
#include "tests/cli/small_study.hpp"

namespace mpmvv::cli::study_refusal_test {

using testing::AllOf;
using testing::HasSubstr;

struct BadFile {
  const char* from;  ///< text of the small study to replace
  const char* to;
  const char* message;
};

void PrintTo(const BadFile& bad, std::ostream* out) {
  *out << bad.message;
}

class BadStudy : public testing::TestWithParam<BadFile> {};

TEST_P(BadStudy, NamesFileAndLineAndWritesNothing) {
  const Folder folder;
  std::string text = small_study;
  text.replace(text.find(GetParam().from), std::string(GetParam().from).size(), GetParam().to);
  const std::string file = folder.write("bad.toml", text), db = folder / "r.db";
  const Answer answer = call(folder, "study " + file + " --db " + db);
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
  EXPECT_THAT(answer.err, HasSubstr("bad.toml:"));
  EXPECT_THAT(answer.err, HasSubstr(GetParam().message));
  EXPECT_FALSE(std::filesystem::exists(db));
}

/// All others: tests/studies/plan/study_refusal_test.cpp.
INSTANTIATE_TEST_SUITE_P(
    , BadStudy,
    testing::Values(BadFile{"[8, 16, 32, 64]\n[[fit", "[8, 16, 32, 64, -16]\n[[fit", "cells = -16"},
                    BadFile{"claims = [\"S-fig10\"]", "claims = [\"S-fig10\", \"S-foo\"]", "unknown claim 'S-foo'"},
                    BadFile{"title = \"Small\"", "title = 'Small", "bad.toml"}));

TEST(StudyCommand, ACheckHasNoSettings) {
  const Folder folder;
  const std::string check = folder.write("jump.toml", "title = \"Jump\"\nclaims = []\ncheck = \"jump-errors\"\n"),
                    small = folder.write("small.toml", small_study);
  const std::string db = folder / "r.db";
  for (const char* option : {"--set", "--set-where-taken"}) {
    const auto study = [&](const std::string& files, const std::string& setting) {
      return call(folder, "study " + files + " " + option + " " + setting + " --db " + db);
    };
    EXPECT_THAT(study(check, "nonsense=1").err, HasSubstr(std::string("unknown key 'nonsense' in ") + option));
    const Answer alone = study(check, "shuffle=3");
    EXPECT_EQ(alone.code, 2);
    EXPECT_EQ(alone.err,
              std::string("mpmvv: no series takes shuffle = 3 (a check has no settings for ") + option + ")\n");
    EXPECT_FALSE(std::filesystem::exists(db));
    const Answer mixed = study(check + " " + small + " --plan", "shuffle=3");
    EXPECT_EQ(mixed.code, 0);
    EXPECT_THAT(mixed.err, AllOf(HasSubstr("jump: shuffle = 3 changes nothing in a check"),
                                 HasSubstr("small: shuffle = 3 in 2 of 2 series")));
  }
}

TEST(StudyCommand, HasNoGroundsToPrintWhereItMakesNoStudy) {
  const Folder folder;
  const std::string study = "study " + folder.write("small.toml", small_study) + " --db " + (folder / "r.db");
  for (const std::string option : {"--plan", "--shard 1/2"}) {
    const Answer answer = call(folder, study + " --verbose " + option);
    EXPECT_EQ(answer.code, 2) << option;
    EXPECT_THAT(answer.err, HasSubstr("excludes"));
    EXPECT_FALSE(std::filesystem::exists(folder / "r.db"));
  }
}

TEST(StudyCommand, RefusesStoresThatAreNone) {
  const Folder folder;
  const std::string file = folder.write("small.toml", small_study);
  const std::string foreign =
      folder.write("foreign.db", "this is no database, but long enough to look like a file of its own");
  const Answer answer = call(folder, "study " + file + " --db " + foreign);
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
  EXPECT_THAT(answer.err, HasSubstr("foreign.db' is not a results store: no SQLite file"));
  EXPECT_EQ(read_text(foreign), "this is no database, but long enough to look like a file of its own");
  const auto refusal = [&](const std::string& arguments) {
    const Answer refused = call(folder, arguments);
    EXPECT_EQ(refused.code, 2) << arguments;
    return refused.err;
  };
  EXPECT_THAT(refusal("gate --db " + (folder / "absent.db")), HasSubstr("no results store '"));
  EXPECT_THAT(refusal("study " + file + " --db " + (folder / "no/such/folder.db")), HasSubstr("no folder '"));
}

TEST(StudyCommand, RefusesTwoStudiesOfOneName) {
  const Folder folder;
  for (const char* sub : {"a", "b"}) {
    std::filesystem::create_directories(folder / sub);
    folder.write(std::string(sub) + "/small.toml", small_study);
  }
  const Answer answer = call(folder, "study a/small.toml b/small.toml --db r.db", "cd '" + (folder / "") + "' && ");
  EXPECT_EQ(answer.code, 2);
  EXPECT_EQ(answer.err, "mpmvv: two study files named 'small' (stems must differ)\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "r.db"));
}

TEST(BadStudyName, IsRefusedAtTheEntry) {
  const Folder folder;
  const std::string db = folder / "r.db";
  for (const std::string& stem : std::vector<std::string>{"a b", "a#b", "-a", "é", "a;b", std::string(101, 'a')}) {
    const Answer answer = call(folder, "study '" + folder.write(stem + ".toml", small_study) + "' --db " + db);
    EXPECT_EQ(answer.code, 2) << stem;
    EXPECT_THAT(answer.err, HasSubstr("cannot name a study"));
  }
  EXPECT_FALSE(std::filesystem::exists(db));
}

}  // namespace mpmvv::cli::study_refusal_test
