#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "goldens/mutants/alarm_log.hpp"
#include "goldens/mutants/code_tokens.hpp"
#include "goldens/mutants/mistake.hpp"
#include "goldens/mutants/mutation.hpp"
#include "goldens/mutants/program_bench.hpp"
#include "studies/support/error.hpp"

namespace mpmvv {
namespace mutant_edit_test {

using support::UsageError;

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsSupersetOf;

/// A folder of its own for every test, gone at its end.
class MutantFiles : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& text) const {
    std::ofstream(folder_ / "list.toml") << text;
    return folder_ / "list.toml";
  }

  /// What reading the list complains of.
  std::string complaint(const std::string& text) const {
    try {
      read_mistakes(write(text));
    } catch (const UsageError& e) {
      return e.what();
    }
    return "";
  }

  fs::path folder_ = fs::temp_directory_path() /
                     (std::string("mpmvv_mutants_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
                      std::to_string(getpid()));
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
  const auto mistakes = read_mistakes(write(std::string(sign) + "shows = \"nothing\"\nreason = \"why\"\n"));
  ASSERT_EQ(mistakes.size(), 1U);
  EXPECT_EQ(mistakes[0].name, "sign");
  EXPECT_EQ(mistakes[0].reason, "why");
  EXPECT_THAT(mistakes[0].where, HasSubstr("list.toml:2"));
}

TEST_F(MutantFiles, MistakesInTheListAreNamedWithTheirLine) {
  EXPECT_THAT(complaint(""), HasSubstr("no mistake"));
  EXPECT_THAT(complaint(std::string(sign) + sign), HasSubstr("a second mistake 'sign'"));
  EXPECT_THAT(complaint(std::string(sign) + "shown = 1"), HasSubstr("unknown key 'shown'"));
  EXPECT_THAT(complaint(std::string(sign) + "shows = \"much\""), HasSubstr("shows = 'much'"));
  EXPECT_THAT(complaint(std::string(sign) + "shows = \"nothing\""), HasSubstr("'reason' is missing"));
  EXPECT_THAT(complaint(std::string(sign) + "reason = \"why\""), HasSubstr("'reason' without 'shows'"));
  EXPECT_THAT(complaint("[[mistake]]\nname = \"A sign\""), HasSubstr("name 'A sign'"));
  EXPECT_THAT(complaint("[[mistake]]\nname = \"a\"\nwhat = \" \""), HasSubstr("'what' is blank in"));
  EXPECT_THAT(complaint("[[mistake]]\nname = \"a\"\nwhat = \"b\"\nfile = \"c\"\nfind = \"d\"\nreplace = \"d\""),
              HasSubstr("changes nothing"));
}

TEST_F(MutantFiles, WhatIsToBeFoundOccursOnce) {
  const Mistake mistake = read_mistakes(write(sign)).front();
  const std::string text = "one\na = b + c;\n";
  EXPECT_EQ(edited(edit_of(mistake, text), text), "one\na = b - c;\n");
  for (const std::string other : {"a = b - c", "b + c + b + c"}) {
    try {
      edit_of(mistake, other);
      ADD_FAILURE() << other;
    } catch (const UsageError& e) {
      EXPECT_THAT(e.what(), HasSubstr("exactly once"));
    }
  }
}

TEST_F(MutantFiles, ReasonsReachTheirMutants) {
  std::ofstream(folder_ / "planted.toml") << sign << "shows = \"nothing\"\nreason = \"why\"\n";
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
  EXPECT_NO_THROW(reasons.check(mutants));
  mutants[1].before = "x < z";
  try {
    reasons.check(mutants);
    ADD_FAILURE() << "a reason for a line that has changed";
  } catch (const UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("explained.toml:1 (a line as it stands there"));
  }
}

TEST_F(MutantFiles, WhatIsReviewedFollowsTheList) {
  std::ofstream(folder_ / "planted.toml") << sign;
  EXPECT_TRUE(reviewed({}, folder_).empty());
  std::vector<Mutant> mutants(2);
  mutants[0].name = "no longer planted";
  mutants[1].kind = Mutant::Kind::random;
  const auto all = reviewed(mutants, folder_);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].kind, Mutant::Kind::random);
  EXPECT_EQ(all[1].name, "sign");
  EXPECT_TRUE(all[1].open());
}

TEST_F(MutantFiles, RunsWithoutAMistakeAreRead) {
  EXPECT_TRUE(read_alarms(folder_).runs.empty());
  std::ofstream(folder_ / "alarms.toml")
      << "digest = 'd1'\n[[run]]\nnumber = 3\nbuild = 'g++ -O2'\nshuffle = 7\ngrid_offset = 0.37\npass = 579\n"
         "fail = 1\ninconclusive = 0\ntold = '''\nfail a: order of 'b''''\n";
  const AlarmLog log = read_alarms(folder_);
  EXPECT_EQ(log.digest, "d1");
  ASSERT_EQ(log.runs.size(), 1U);
  EXPECT_EQ(log.runs[0].build, "g++ -O2");
  EXPECT_EQ(log.runs[0].pass, 579);
  EXPECT_TRUE(log.runs[0].is_alarm());
  std::ofstream(folder_ / "alarms.toml")
      << "digest = 'd1'\n[[run]]\nbuild = 'g++'\nshuffle = 1\ngrid_offset = 0\npass = -1\n";
  try {
    read_alarms(folder_);
    ADD_FAILURE();
  } catch (const UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("alarms.toml:6 (a count)"));
  }
}

TEST(Edits, LinesAreWholeWithoutTheirIndentation) {
  const std::string text = "first\n  second line\n  third\n";
  EXPECT_EQ(line_of(text, text.find("line")), 2);
  EXPECT_EQ(lines_at(text, text.find("line"), 4), "second line");
  EXPECT_EQ(lines_at(text, text.find("line"), 9), "second line\n  third");
  EXPECT_EQ(lines_at(text, 0, 1), "first");
}

std::vector<std::string> texts_of(const std::string& code) {
  std::vector<std::string> texts;
  for (const Token& token : tokens_of(code)) texts.emplace_back(token.text);
  return texts;
}

TEST(CodeTokens, CommentsStringsAndDirectivesAreLeftOut) {
  EXPECT_THAT(
      texts_of("#define A 1 + 2\n"
               "a = \"b \\\" + c\" + 'd';  // + e\n"
               "/* f + */ g(R\"x(h + )\" )x\", 1e-3);\n"
               "[[gnu::noinline]] i->j >= 10'000;"),
      testing::ElementsAre("a", "=", "+", ";", "g", "(", ",", "1e-3", ")", ";", "i", "->", "j", ">=", "10'000", ";"));
}

TEST(CodeTokens, TemplateBracketsAreToldFromComparisons) {
  const std::string code = "std::vector<std::array<int, 2 + 1>> a = b < c && d > e ? f<3>(1) : 4 >> 5;";
  std::string inside;
  for (const Token& token : tokens_of(code))
    if (token.in_brackets) inside += token.text;
  EXPECT_EQ(inside, "<std::array<int,2+1>><3>");
}

/// "before becomes after" for every mutation of a code.
std::vector<std::string> changes(const std::string& code) {
  std::vector<std::string> all;
  for (const Edit& edit : mutations_of("a.cpp", code)) all.push_back(edit.before + " becomes " + edit.after);
  return all;
}

TEST(Mutations, OperatorsOperandsAndNumbersChange) {
  EXPECT_THAT(changes("a = b + c;"), testing::ElementsAre("+ becomes -"));
  EXPECT_THAT(changes("a = -b * c;"), testing::ElementsAre("- becomes ", "* becomes /"));
  EXPECT_THAT(changes("a += b; c *= d;"), testing::ElementsAre("+= becomes -=", "*= becomes /="));
  EXPECT_THAT(changes("return a < b;"), testing::ElementsAre("< becomes <=", "< becomes >"));
  EXPECT_THAT(changes("if (a == b) c(d != e);"), testing::ElementsAre("== becomes !=", "!= becomes =="));
  EXPECT_THAT(changes("a = 0.5; b = 0.25; c = 2;"),
              testing::ElementsAre("0.5 becomes 1", "0.25 becomes (2 * 0.25)", "2 becomes 3"));
  EXPECT_THAT(changes("x[d] = F(c, d);"), testing::ElementsAre("d becomes 0", "c, d becomes d, c"));
  EXPECT_THAT(changes("f(i, x[j]);"), testing::ElementsAre("j becomes i"));
  EXPECT_THAT(changes("f(true);"), testing::ElementsAre("true becomes false"));
}

TEST(Mutations, WhatIsNoOperationStays) {
  for (const char* code :
       {"double* a; const Vec<D>& b = *c;", "std::array<double, 3> a;", "virtual void f() const = 0;", "a->b();",
        "out << a << b;", "// a + 1", "#include <a+1>", "s = \"a + 1\";", "static_assert(a == 2);", "case 3:", "++i;"})
    EXPECT_THAT(changes(code), testing::IsEmpty()) << code;
}

std::vector<Edit> numbered(int count) {
  std::vector<Edit> edits;
  for (int k = 0; k < count; ++k) edits.push_back({"a.cpp", static_cast<std::size_t>(k), "", ""});
  return edits;
}

TEST(Mutations, TheSeedAloneDecidesTheDraw) {
  std::vector<std::size_t> places;
  for (const Edit& edit : shuffled(numbered(10), 1)) places.push_back(edit.at);
  EXPECT_THAT(places, testing::UnorderedElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9));
  std::vector<std::size_t> again, other;
  for (const Edit& edit : shuffled(numbered(10), 1)) again.push_back(edit.at);
  for (const Edit& edit : shuffled(numbered(10), 2)) other.push_back(edit.at);
  EXPECT_EQ(places, again);
  EXPECT_NE(places, other);
}

std::string source(const std::string& file) {
  return (std::stringstream() << std::ifstream(std::string(MPMVV_SOURCE_DIR) + "/" + file).rdbuf()).str();
}

/// Not run where a mistake is planted: see ProgramBench.
TEST(PlantedMistakes, EveryOneApplies) {
  std::set<std::string> folders;
  for (const Mistake& mistake : read_mistakes(std::string(MPMVV_SOURCE_DIR) + "/goldens/mutants/planted.toml")) {
    EXPECT_NO_THROW(edit_of(mistake, source(mistake.file))) << mistake.name;
    folders.insert(mistake.file.substr(0, mistake.file.find('/')));
  }
  EXPECT_THAT(folders, testing::ElementsAre("goldens", "mms", "reports", "solver", "studies"));
}

TEST(PlantedMistakes, RandomOnesLieInCode) {
  const std::string file = "solver/basis/gimp.hpp", text = source(file);
  const auto edits = mutations_of(file, text);
  EXPECT_GT(edits.size(), 20U);
  for (const Edit& edit : edits) {
    const std::string line = lines_at(text, edit.at, 1);
    EXPECT_FALSE(line.starts_with("//") || line.starts_with("#")) << line;
    EXPECT_NE(edited(edit, text), text);
  }
}

TEST(GateOutput, StudiesOfAListHaveNoCommentsAndEndings) {
  EXPECT_THAT(listed_studies("# what\nb.toml\n\n a-1.toml # why\n"), testing::ElementsAre("b", "a-1"));
}

TEST(GateOutput, TheTestThatFailedIsNamed) {
  EXPECT_EQ(failed_test("[ RUN      ] A.B\n[       OK ] A.B (0 ms)\n[ RUN      ] A.C\nx\n[  FAILED  ] A.C (1 ms)\n"),
            "A.C");
  EXPECT_EQ(failed_test("[  FAILED  ] A/0.B, where TypeParam = C (1 ms)\n"), "A/0.B");
  EXPECT_EQ(failed_test("[ RUN      ] A.B\n[       OK ] A.B (0 ms)\n[ RUN      ] A.C\n"), "A.C");
  EXPECT_EQ(failed_test(""), "before the first test");
}

TEST(GateOutput, GoldensThatDoNotPassAreNamed) {
  const char* json = R"({"results": [{"study": "s", "name": "order", "verdict": "pass"},
                                     {"study": "t", "name": "limit", "verdict": "inconclusive"},
                                     {"study": "s", "name": "error", "verdict": "fail"}]})";
  EXPECT_THAT(goldens_not_passed(json), testing::ElementsAre("s: error", "t: limit (inconclusive)"));
  EXPECT_THAT(goldens_not_passed("Segmentation"), testing::ElementsAre("the gate prints no JSON"));
}

TEST(GateOutput, TheFirstStudyOfWhichAnythingFailsEndsTheStage) {
  std::vector<std::string> asked;
  const auto caught_by = [&](std::map<std::string, std::vector<std::string>> complaints) {
    asked.clear();
    return first_catch(GateStage::quick, {"a", "b", "c"}, [&](const std::string& study) {
      asked.push_back(study);
      return complaints[study];
    });
  };
  EXPECT_FALSE(caught_by({}).caught);
  const Trial decided = caught_by({{"a", {"a: x (inconclusive)"}}, {"b", {"b: y", "b: z (inconclusive)"}}});
  EXPECT_TRUE(decided.caught);
  EXPECT_THAT(decided.by, testing::ElementsAre("b: y", "b: z (inconclusive)"));
  EXPECT_THAT(asked, testing::ElementsAre("a", "b"));
  const Trial doubtful = caught_by({{"b", {"b: x (inconclusive)"}}, {"c", {"c: y (inconclusive)"}}});
  EXPECT_TRUE(doubtful.caught);
  EXPECT_THAT(doubtful.by, testing::ElementsAre("b: x (inconclusive)"));
}

TEST(GateOutput, AnEditReachesTheTestsThatLinkIt) {
  EXPECT_THAT(test_programs("solver/grid.hpp"), testing::ElementsAre("test_cli", "test_studies", "test_solver"));
  EXPECT_THAT(test_programs("mms/bar.cpp"), testing::Contains("test_mms"));
  EXPECT_THAT(test_programs("reports/csv.cpp"), testing::ElementsAre("test_reports", "test_cli"));
  EXPECT_THAT(test_programs("studies/runs/norms.hpp"), IsSupersetOf({"test_studies", "test_goldens", "test_reports"}));
}

}  // namespace mutant_edit_test
}  // namespace mpmvv
