#include "tests/mutation/mistake.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "studies/support/error.hpp"
#include "tests/mutation/anchor.hpp"
#include "tests/mutation/operators.hpp"
#include "tests/mutation/tests/samples.hpp"
#include "tests/mutation/unmatched.hpp"
#include "tests/own_folder.hpp"
#include "tests/walk.hpp"

namespace mpmvv::mutation::mutant_edit_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder of its own for every test, gone at its end.
class MutantFiles : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& text) const {
    std::ofstream(folder_ / "list.toml") << text;
    return folder_ / "list.toml";
  }

  /// What reading the list complains of.
  std::string complaint(const std::string& text) const {
    try {
      read_mistakes(write(text));
    } catch (const support::UsageError& e) {
      return e.what();
    }
    return "";
  }

  fs::path folder_ = own_folder("mutants");
};

constexpr const char* sign = R"(
[[mistake]]
name = "sign"
what = "a sign"
file = "a.hpp"
find = "b + c"
replace = "b - c"
)";

TEST_F(MutantFiles, AMistakeIsRead) {
  const auto mistakes = read_mistakes(write(std::string(sign) + "equivalent = \"why\"\n"));
  ASSERT_EQ(mistakes.size(), 1U);
  EXPECT_EQ(mistakes[0].name, "sign");
  EXPECT_EQ(mistakes[0].reason, "why");
  EXPECT_THAT(mistakes[0].where, HasSubstr("list.toml:2"));
}

/// As it is planted, in code that the sources have once.
TEST_F(MutantFiles, ThePageOfThemShowsOne) {
  const std::string top = MPMVV_SOURCE_DIR;
  const auto shown = read_mistakes(write(walk("mistake")));
  ASSERT_EQ(shown.size(), 1U);
  for (const Unmatched& entry : unmatched(shown, {}, read_sources(top)))
    ADD_FAILURE() << entry.complaint << "\n" << entry.nearest;
  const auto planted = read_mistakes(top + "/tests/mutation/planted.toml");
  const auto same = std::ranges::find(planted, shown[0].name, &Mistake::name);
  ASSERT_NE(same, planted.end());
  EXPECT_EQ(same->find, shown[0].find);
  EXPECT_EQ(same->replace, shown[0].replace);
}

TEST_F(MutantFiles, MistakesInTheListAreNamedWithTheirLine) {
  EXPECT_THAT(complaint(""), HasSubstr("no mistake"));
  EXPECT_THAT(complaint(std::string(sign) + sign), HasSubstr("a second mistake 'sign'"));
  EXPECT_THAT(complaint(std::string(sign) + "shown = 1"), HasSubstr("unknown key 'shown'"));
  EXPECT_THAT(complaint(std::string(sign) + "equivalent = \" \""), HasSubstr("'equivalent' is blank in"));
  EXPECT_THAT(complaint(std::string(sign) + "equivalent = true"), HasSubstr("list.toml:8"));
  EXPECT_THAT(complaint(std::string(sign) + "function = \"\""), HasSubstr("'function' is blank in"));
  EXPECT_THAT(complaint("[[mistake]]\nname = \"A sign\""), HasSubstr("name 'A sign'"));
  EXPECT_THAT(complaint("[[mistake]]\nname = \"a\"\nwhat = \" \""), HasSubstr("'what' is blank in"));
  EXPECT_THAT(complaint("[[mistake]]\nname = \"a\"\nwhat = \"b\"\nfile = \"c\"\nfind = \"d\"\nreplace = \"d\""),
              HasSubstr("changes nothing"));
}

TEST_F(MutantFiles, WhatIsToBeFoundOccursOnce) {
  const Mistake mistake = read_mistakes(write(sign)).front();
  const std::string text = "one\na = b + c;\n";
  EXPECT_EQ(edited(edit_of(mistake, "a.hpp", text), text), "one\na = b - c;\n");
  for (const std::string other : {"a = b - c", "b + c + b + c"}) {
    try {
      edit_of(mistake, "a.hpp", other);
      ADD_FAILURE() << other;
    } catch (const support::UsageError& e) {
      EXPECT_THAT(e.what(), HasSubstr("exactly once"));
      EXPECT_THAT(e.what(), HasSubstr("list.toml:2"));
    }
  }
}

TEST_F(MutantFiles, ReasonsReachTheirMutants) {
  std::ofstream(folder_ / "planted.toml") << sign << "equivalent = \"why\"\n";
  std::ofstream(folder_ / "explained.toml")
      << "[[survivor]]\nfile = \"a.hpp\"\nbefore = \"x < y\"\nafter = \"x <= y\"\nreason = \"equal\"\n";
  std::vector<Mutant> mutants(3);
  mutants[0].name = "sign";
  for (Mutant& mutant : mutants) mutant.file = "a.hpp";
  for (const std::size_t k : {1, 2}) mutants[k].kind = Mutant::Kind::random, mutants[k].before = "x < y";
  mutants[1].after = "x <= y";
  mutants[2].after = "x > y";
  const Reasons reasons(folder_);
  EXPECT_EQ(reasons.of(mutants[0]), "why");
  EXPECT_EQ(reasons.of(mutants[1]), "equal");
  EXPECT_EQ(reasons.of(mutants[2]), "");
  mutants[1].file = "solver/inner/a.hpp", mutants[1].before = "x<y  // as it is laid out now";
  EXPECT_EQ(reasons.of(mutants[1]), "equal");
  mutants[1].before = "x < z";
  EXPECT_EQ(reasons.of(mutants[1]), "") << "the line has changed";
}

TEST_F(MutantFiles, WhatIsReviewedFollowsTheList) {
  std::ofstream(folder_ / "planted.toml") << sign;
  EXPECT_TRUE(Reasons(folder_).reviewed({}).empty());
  std::vector<Mutant> mutants(2);
  mutants[0].name = "no longer planted";
  mutants[1].kind = Mutant::Kind::random;
  const auto all = Reasons(folder_).reviewed(mutants);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].kind, Mutant::Kind::random);
  EXPECT_EQ(all[1].name, "sign");
  EXPECT_TRUE(all[1].open());
}

TEST(PlantedMistakes, EveryOneApplies) {
  const std::string top = MPMVV_SOURCE_DIR, lists = top + "/tests/mutation/";
  const auto mistakes = read_mistakes(lists + "planted.toml");
  const Sources sources = read_sources(top);
  for (const Unmatched& entry : unmatched(mistakes, read_explanations(lists + "explained.toml"), sources))
    ADD_FAILURE() << entry.complaint << "\n" << entry.nearest;
  if (HasFailure()) return;
  std::set<std::string> folders;
  const std::vector<std::string> files = samples::sources();
  for (const Mistake& mistake : mistakes) {
    const std::string file = file_of(mistake, files), &text = sources.at(file);
    EXPECT_NE(edited(edit_of(mistake, file, text), text), text) << mistake.name;
    folders.insert(file.substr(0, file.find('/')));
  }
  EXPECT_THAT(folders, testing::ElementsAre("goldens", "mms", "reports", "solver", "studies"));
}

TEST(PlantedMistakes, RandomOnesLieInCode) {
  const std::string file = sources_named("gimp.hpp", samples::sources()).at(0), text = samples::source(file);
  const auto edits = mutations_of(file, text);
  EXPECT_GT(edits.size(), 20U);
  for (const Edit& edit : edits) {
    const std::string line = lines_at(text, edit.at, 1);
    EXPECT_FALSE(line.starts_with("//") || line.starts_with("#")) << line;
    EXPECT_NE(edited(edit, text), text);
  }
}

}  // namespace mpmvv::mutation::mutant_edit_test
