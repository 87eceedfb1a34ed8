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

TEST(AskedText, OfAnAwaitedPartIsThatWord) {
  ClaimPart part;
  part.measure = support::to_string(claims::Criterion::Kind::awaited);
  EXPECT_EQ(asked_text(part), "awaited");
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
  EXPECT_THAT(undecided_text(part), HasSubstr("at l2 1e-02 = 0.5 (0.3 to 0.7). More rounds in one session might"));
}

TEST(IntervalText, SaysTheRangeOfReplicates) {
  ClaimPart part = asked(std::nullopt, 0.6);
  part.measure = "error", part.verdict = PartVerdict::inconclusive;
  part.found = {{"l2 of 'a' at cells = 8", 0.5}};
  part.evidence = "l2 of 'a' at cells = 8 (0.3 to 0.7) = 0.5 (asked: at most 0.6, but an interval reaches across)";
  EXPECT_EQ(interval_of(part, part.found[0]), std::pair(0.3, 0.7));
  EXPECT_THAT(undecided_text(part), HasSubstr("= 0.5 (0.3 to 0.7). Other replicates might lie"));
}

TEST(IntervalOf, AnOrderLiesWithinItsHalfWidthWhateverItsFinestSegment) {
  ClaimPart part = asked(1.95, std::nullopt);
  part.measure = "order", part.verdict = PartVerdict::inconclusive;
  part.found = {{"order of 'a'", 2}};
  part.evidence = "order of 'a' (±0.1, finest segment 1.41) = 2 (asked: at least 1.95, but an interval reaches across)";
  EXPECT_EQ(interval_text(part, part.found[0]), " ± 0.1");
  EXPECT_EQ(interval_of(part, part.found[0]), std::pair(1.9, 2.1));
  EXPECT_THAT(undecided_text(part), HasSubstr("order of 'a' = 2 ± 0.1. Other points"));
}

fits::StabilityLimit limit(double stable, double unstable) {
  return {"cfl", stable, unstable, true, true, {}};
}

/// Stable at all values tried, up to 1.
fits::StabilityLimit limit_above_one() {
  return {"cfl", 1, support::not_measured, true, false, {{0.5, true, ""}, {1, true, ""}}};
}

/// What is found of the limits of 'a', 'b', ..., which are asked to be this at most.
ClaimPart judged_limits(const std::vector<fits::StabilityLimit>& limits, double at_most) {
  records::StudyResult study;
  study.sweep = "cfl";
  claims::Criterion criterion;
  criterion.kind = claims::Criterion::Kind::limit, criterion.at_most = at_most;
  for (const auto& of_series : limits) {
    criterion.series.emplace_back(1, static_cast<char>('a' + study.series.size()));
    study.series.push_back({criterion.series.back(), {}, {}, of_series});
  }
  return claims::judge(criterion, study);
}

TEST(IntervalOf, ALimitLiesInItsBracket) {
  for (const auto& found : {limit(0.4375, 0.4401), limit(0.4401, 0.4375)}) {
    const ClaimPart part = judged_limits({found}, 0.439);
    ASSERT_EQ(part.verdict, PartVerdict::inconclusive);
    EXPECT_EQ(interval_of(part, part.found[0]), std::pair(0.4375, 0.4401));
    EXPECT_EQ(reach_of(part, part.found[0]), 0);
    EXPECT_THAT(undecided_text(part), HasSubstr("= 0.4388. A finer search might decide."));
  }
}

TEST(IntervalOf, ARatioOfLimitsLiesWhereTheirBracketsLetIt) {
  ClaimPart part;
  part.measure = "limit-ratio", part.found = {{"limit of 'a' over 'b' between 0.9 and 1.2", 1.05}};
  EXPECT_EQ(interval_of(part, part.found[0]), std::pair(0.9, 1.2));
  part.found[0].what = "limit of 'a' over 'b' between 0.9 and 1.2, that of 'b' not monotone";
  EXPECT_EQ(interval_of(part, part.found[0]), std::pair(0.9, 1.2));
  part.found[0].what = "cfl limit of 'a' between 1 and 2, not monotone";
  EXPECT_EQ(interval_of(part, part.found[0]), std::pair(1.0, 2.0));
  part.found[0].what = "cfl limit of 'a' between b', stable at all values tried, up to 1";
  EXPECT_EQ(interval_of(part, part.found[0]), std::pair(1.05, 1.05)) << "the name of a series is no bracket";
}

/// That of 'b' lies nearer to the bound, but it is 'a' that may lie anywhere beyond it.
TEST(IntervalOf, ALimitBeyondAllValuesTriedHasOneEnd) {
  const ClaimPart part = judged_limits({limit_above_one(), limit(1.1, 1.15)}, 1.2);
  ASSERT_EQ(part.verdict, PartVerdict::inconclusive);
  EXPECT_EQ(interval_of(part, part.found[0]), std::pair(1.0, HUGE_VAL));
  EXPECT_THAT(undecided_text(part), HasSubstr("limit of 'a', stable at all values tried, up to 1 = 1 or more. A search "
                                              "beyond the values tried might decide."));
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
