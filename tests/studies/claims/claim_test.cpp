#include "studies/claims/claim.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mpmvv::claims {
namespace claim_test {

std::string verdict(std::vector<records::PartVerdict> verdicts) {
  records::StudyResult study;
  study.name = "a-study";
  for (const records::PartVerdict v : verdicts) study.parts.push_back({"S-fig10", "statement", v, "evidence", ""});
  for (const Claim& claim : judge_claims({study}))
    if (claim.id == "S-fig10") return claim.verdict;
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

TEST(Claims, EveryIdIsThereOnce) {
  std::vector<std::string> ids;
  for (const ClaimText& text : claim_list()) ids.push_back(text.id);
  EXPECT_EQ(ids.size(), 73U);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

}  // namespace claim_test
}  // namespace mpmvv::claims
