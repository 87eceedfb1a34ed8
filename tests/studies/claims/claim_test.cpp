#include "studies/claims/claim.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mpmvv::claims::claim_test {

using records::StudyResult;
using testing::ElementsAre;

/// A study that names these claims.
StudyResult naming(const std::string& name, const std::vector<std::string>& claims) {
  StudyResult study;
  study.name = name;
  study.claims = claims;
  return study;
}

std::string verdict(const std::vector<records::PartVerdict>& verdicts) {
  StudyResult study = naming("a-study", {"S-fig10"});
  for (const records::PartVerdict v : verdicts) study.parts.push_back({"S-fig10", "statement", v, "evidence", ""});
  for (const Claim& claim : judge_claims({study}))
    if (claim.id == "S-fig10") return to_string(claim.verdict);
  return "";
}

TEST(Claims, VerdictFollowsFromTheParts) {
  using enum records::PartVerdict;
  EXPECT_EQ(verdict({}), "open");
  EXPECT_EQ(verdict({holds, holds}), "confirmed");
  EXPECT_EQ(verdict({fails, fails}), "refuted");
  EXPECT_EQ(verdict({holds, fails}), "partly");
  EXPECT_EQ(verdict({inconclusive, fails}), "refuted") << "whatever the other part turns out to be, one does not hold";
  EXPECT_EQ(verdict({holds, inconclusive}), "partly");
  EXPECT_EQ(verdict({inconclusive}), "open");
  EXPECT_EQ(verdict({shown}), "shown");
  EXPECT_EQ(verdict({shown, holds}), "confirmed");
}

std::vector<std::string> ids_of(const std::vector<Claim>& claims) {
  std::vector<std::string> ids;
  for (const Claim& claim : claims) ids.push_back(claim.id);
  return ids;
}

TEST(Claims, AreThoseThatStudiesName) {
  EXPECT_THAT(judge_claims({naming("no-claims", {})}), testing::IsEmpty());
  const auto claims = judge_claims({naming("mine", {"M-flat", "M-steep"}), naming("other", {"M-flat"})});
  EXPECT_THAT(ids_of(claims), ElementsAre("M-flat", "M-steep"));
  EXPECT_EQ(claims[0].verdict, Claim::Verdict::open);
}

/// Studies come from a store in the order of their letters.
TEST(Claims, StandInTheOrderOfTheStudiesThatStateThem) {
  StudyResult cost = naming("n-cost", {"X-cost"}), tenth = naming("s-fig10", {"S-fig10"}),
              fourth = naming("s-fig4", {"S-fig4"});
  cost.statements = {{"X-cost", "least run time", "mpmvv", "", "x-cost"}};
  EXPECT_THAT(ids_of(judge_claims({cost, tenth, fourth})), ElementsAre("S-fig4", "S-fig10", "X-cost"));
}

TEST(Claims, SayWhatTheirOwnStudySays) {
  StudyResult other = naming("a-study", {"S-fig10"}), own = naming("s-fig10", {"S-fig10"});
  other.statements = {{"S-fig10", "as it was", "", "", "s-fig10"}};
  own.statements = {{"S-fig10", "as it is", "Steffen et al. 2008", "Fig. 10", "s-fig10"}};
  EXPECT_EQ(judge_claims({other})[0].statement, "as it was");
  const Claim claim = judge_claims({other, own})[0];
  EXPECT_EQ(claim.statement, "as it is");
  EXPECT_EQ(claim.source, "Steffen et al. 2008");
  EXPECT_EQ(claim.where, "Fig. 10");
}

TEST(Claims, HoldTheirPartsAndWhereTheyStand) {
  StudyResult one = naming("one", {"S-fig10"}), two = naming("two", {"S-fig10"});
  one.parts = {{"S-fig10", "flat", records::PartVerdict::holds, "", "", "spread", {}, 1.5, {{"of 'cd'", 1.25}}}};
  two.parts = {{"S-fig9", "of another", records::PartVerdict::fails, "", ""},
               {"S-fig10", "steep", records::PartVerdict::fails, "", "why"}};
  const Claim claim = judge_claims({one, two})[0];
  ASSERT_EQ(claim.parts.size(), 2U);
  EXPECT_EQ(claim.parts[0].study, "one");
  EXPECT_EQ(claim.parts[0].part.found.at(0).value, 1.25);
  EXPECT_EQ(claim.parts[1].study, "two");
  EXPECT_EQ(claim.parts[1].part.reason, "why");
  EXPECT_THAT(claim.studies, ElementsAre("one", "two"));
  EXPECT_EQ(claim.verdict, Claim::Verdict::partly);
}

}  // namespace mpmvv::claims::claim_test
