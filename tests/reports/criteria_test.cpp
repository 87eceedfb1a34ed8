#include "reports/criteria.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "studies/claims/criterion.hpp"

/// Bounds, found numbers and what decides, in words.
namespace mpmvv::reports::criteria_test {

using records::ClaimPart;
using records::PartVerdict;

using testing::HasSubstr;

ClaimPart asked(std::optional<double> at_least, std::optional<double> at_most) {
  ClaimPart part;
  part.at_least = at_least, part.at_most = at_most;
  return part;
}

TEST(AskedText, HasAllDigitsOfABound) {
  EXPECT_EQ(asked_text(asked(1.000001, std::nullopt)), "at least 1.000001");
  EXPECT_EQ(asked_text(asked(std::nullopt, 1.000000001)), "at most 1.000000001");
  EXPECT_EQ(asked_text(asked(0.999999, 1.000001)), "0.999999 to 1.000001");
  EXPECT_EQ(asked_text(asked(1.75, 2.25)), "1.75 to 2.25");
  EXPECT_EQ(asked_text(asked(1, 1)), "1");
  EXPECT_EQ(asked_text(asked(std::nullopt, 1e-12)), "at most 1e-12");
  EXPECT_EQ(asked_text(asked(std::nullopt, std::nullopt)), "");
}

TEST(ToldFromBounds, HasFourDigitsOrThoseThatDiffer) {
  EXPECT_EQ(told_from_bounds(asked(1, std::nullopt), 1.0183456), "1.018");
  EXPECT_EQ(told_from_bounds(asked(0.33, 0.49), 0.329997), "0.329997");
  EXPECT_EQ(told_from_bounds(asked(std::nullopt, 1.000000001), 1.000000002), "1.000000002");
  EXPECT_EQ(told_from_bounds(asked(0.999999, 1.000001), 1 + 3e-9), "1");
  EXPECT_EQ(told_from_bounds(asked(1.000001, std::nullopt), 1.000001), "1.000001");
  EXPECT_EQ(told_from_bounds(asked(1, 2), NAN), "–");
  EXPECT_EQ(told_from_bounds(asked(0, std::nullopt), 1e-310), "1e-310");
}

/// Both of the two runs are unstable: their ratio counts as 1 but is no evidence.
TEST(IntervalText, SaysWhichRatioIsThatOfTwoUnstableRuns) {
  records::StudyResult study;
  study.sweep = "cfl";
  for (const char* name : {"a", "b"})
    study.series.push_back(
        {name, {{0.1, records::Status::ok, "", {{"l2", 0.5}}}, {0.4, records::Status::unstable, "", {}}}, {}, {}});
  claims::Criterion criterion;
  criterion.kind = claims::Criterion::Kind::error_ratio, criterion.series = {"a"}, criterion.over = "b";
  criterion.norm = "l2", criterion.window = {0.1, 0.4}, criterion.at_most = 1;
  const ClaimPart part = claims::judge(criterion, study);
  EXPECT_EQ(part.verdict, PartVerdict::holds);
  ASSERT_EQ(part.found.size(), 2u);
  EXPECT_EQ(interval_text(part, part.found[0]), "");
  EXPECT_EQ(interval_text(part, part.found[1]), " (both unstable)");
  EXPECT_THAT(part.evidence, HasSubstr("at cfl = 0.4: 1 (both unstable) (asked: at most 1)"));
}

/// The number is 0.5, 0.3 to 0.7; it is the other one that decides, which lies nearer to the bound but has no range.
TEST(IntervalText, SaysTheRangeOfTimes) {
  ClaimPart part = asked(std::nullopt, 0.6);
  part.measure = "cost-ratio", part.verdict = PartVerdict::inconclusive;
  part.found = {{"cost of 'a' over 'b' at l2 1e-02", 0.5}, {"cost of 'a' over 'b' at l2 1e-03", 0.55}};
  part.evidence =
      "cost of 'a' over 'b' at l2 1e-02 (0.3 to 0.7) = 0.5; cost of 'a' over 'b' at l2 1e-03 = 0.55 (asked: at most "
      "0.6, but an interval reaches across)";
  EXPECT_EQ(interval_text(part, part.found[0]), " (0.3 to 0.7)");
  EXPECT_EQ(interval_of(part, part.found[0]), std::pair(0.3, 0.7));
  EXPECT_EQ(reach_of(part, part.found[0]), 0);
  EXPECT_EQ(interval_text(part, part.found[1]), "");
  EXPECT_EQ(interval_of(part, part.found[1]), std::pair(0.55, 0.55));
  EXPECT_THAT(undecided_text(part), HasSubstr("at l2 1e-02 = 0.5 (0.3 to 0.7). Other repetitions might lie"));
}

TEST(DecidingText, NamesWhatAValueIsOf) {
  ClaimPart part = asked(-0.05, 0.05);
  part.statement = "the plateau of the second is within 5 %", part.measure = "value";
  part.verdict = PartVerdict::fails, part.found = {{"mean pressure over theory - 1", -0.1029}};
  claims::Claim claim;
  claim.parts = {{"a-study", part}};
  EXPECT_EQ(deciding_text(claim),
            "the plateau of the second is within 5 %: mean pressure over theory - 1: -0.1029 (asked: -0.05 to 0.05)");
  claim.parts[0].part.measure = "error";
  EXPECT_EQ(deciding_text(claim), "mean pressure over theory - 1: -0.1029 (asked: -0.05 to 0.05)");
}

}  // namespace mpmvv::reports::criteria_test
