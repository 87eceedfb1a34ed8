#include "studies/plan/claim_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/support/error.hpp"
#include "tests/studies/store/store_samples.hpp"

namespace mpmvv::plan::claim_reader_test {

using store::store_samples::complaint;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string flat =
    "[[claim]]\nid = \"M-flat\"\nstatement = \"the error is flat\"\nsource = \"Me\"\nwhere = \"p. 1\"\n";
const std::string steep = "[[claim]]\nid = \"M-flat\"\nstatement = \"the error is steep\"\n";

/// Study files in a folder: checks, which say nothing of cases.
class ClaimFiles : public store::store_samples::StoreTest {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& claims, const std::string& tables) const {
    const auto file = folder_ / (name + ".toml");
    std::ofstream(file) << "title = \"T\"\nclaims = [" << claims << "]\ncheck = \"jump-errors\"\n" << tables;
    return file;
  }

  std::vector<StudyPlan> stated(const std::vector<std::filesystem::path>& files) const {
    std::vector<StudyPlan> plans;
    for (const auto& file : files) plans.push_back(read_study(file));
    state_claims(plans, {folder_});
    return plans;
  }
};

TEST_F(ClaimFiles, AStudyStatesItsClaims) {
  const StudyPlan plan = read_study(write("one", "\"S-fig10\"", flat));
  EXPECT_THAT(plan.claims, ElementsAre("S-fig10", "M-flat")) << "what it states it judges, too";
  ASSERT_EQ(plan.statements.size(), 1U);
  const auto& [text, where] = plan.statements[0];
  EXPECT_EQ(text.id + "|" + text.statement + "|" + text.source + "|" + text.where + "|" + text.study,
            "M-flat|the error is flat|Me|p. 1|one");
  EXPECT_THAT(where, HasSubstr("one.toml:4"));
}

TEST_F(ClaimFiles, AnotherStudyNamesItOfTheSameCallOrBesideIt) {
  const auto one = write("one", "", flat), two = write("two", "\"M-flat\"", "");
  for (const auto& files : {std::vector{two}, std::vector{two, one}}) {
    const StudyPlan plan = stated(files).front();
    ASSERT_EQ(plan.statements.size(), 1U);
    EXPECT_EQ(plan.statements[0].text.statement, "the error is flat");
    EXPECT_EQ(plan.statements[0].text.study, "one");
  }
}

TEST_F(ClaimFiles, TheFirstFolderThatStatesItCounts) {
  const auto two = write("two", "\"M-flat\"", "");
  const auto shipped = folder_ / "shipped";
  std::filesystem::create_directories(shipped);
  std::ofstream(shipped / "one.toml") << flat;
  std::vector<StudyPlan> plans{read_study(two)};
  state_claims(plans, {folder_, shipped, folder_ / "absent"});
  EXPECT_EQ(plans[0].statements.at(0).text.statement, "the error is flat");
  write("own", "", steep);
  plans = {read_study(two)};
  state_claims(plans, {folder_, shipped});
  EXPECT_EQ(plans[0].statements.at(0).text.statement, "the error is steep");
}

TEST_F(ClaimFiles, OneThatNoneStatesIsUnknown) {
  const auto two = write("two", "\"M-flat\"", "");
  EXPECT_THAT(complaint([&] { stated({two}); }), HasSubstr("unknown claim 'M-flat' in " + two.string() + ":2"));
}

TEST_F(ClaimFiles, TwoThatSayDifferentThingsAreNamedBoth) {
  const auto one = write("one", "", flat), two = write("two", "", steep), three = write("three", "\"M-flat\"", "");
  const auto names_both = AllOf(HasSubstr("claim 'M-flat'"), HasSubstr("one.toml:4"), HasSubstr("two.toml:4"));
  EXPECT_THAT(complaint([&] { stated({one, two}); }), names_both);
  EXPECT_THAT(complaint([&] { stated({three}); }), names_both) << "beside it";
  write("two", "", flat);
  EXPECT_EQ(complaint([&] { stated({one, two}); }), "") << "in the same words";
}

TEST_F(ClaimFiles, TwoOfOneFileAreRefused) {
  EXPECT_THAT(complaint([&] { read_study(write("one", "", flat + steep)); }),
              AllOf(HasSubstr("one.toml:9"), HasSubstr("one.toml:4")));
}

TEST_F(ClaimFiles, AnIdIsAWordAndAStatementSaysSomething) {
  const auto refusal = [&](const std::string& tables) {
    return complaint([&] { read_study(write("a", "", tables)); });
  };
  EXPECT_THAT(refusal("[[claim]]\nid = \"two words\"\nstatement = \"s\"\n"),
              HasSubstr("a.toml:5 (at most 100 letters"));
  EXPECT_THAT(refusal("[[claim]]\nid = \"M\"\nstatement = \"\"\n"), HasSubstr("'M' in "));
  EXPECT_THAT(refusal("[[claim]]\nid = \"M\"\n"), HasSubstr("'statement' is missing"));
  EXPECT_THAT(refusal("[[claim]]\nid = \"M\"\nstatement = \"s\"\nfrom = \"x\"\n"), HasSubstr("unknown key 'from'"));
}

TEST_F(ClaimFiles, AnotherStudyOfTheStoreSaysNothingElse) {
  const auto plans = stated({write("one", "", flat)});
  const auto refusal = [&](const std::string& study, const std::string& statement) {
    return complaint([&] { require_one_voice(plans, {{"M-flat", statement, "Me", "p. 1", study}}, "r.db"); });
  };
  EXPECT_EQ(refusal("other", "the error is flat"), "");
  EXPECT_EQ(refusal("one", "as it was"), "") << "it takes the place of what it said before";
  EXPECT_THAT(refusal("other", "the error is steep"),
              AllOf(HasSubstr("one.toml:4"), HasSubstr("study 'other' of r.db")));
}

}  // namespace mpmvv::plan::claim_reader_test
