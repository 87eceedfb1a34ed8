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

TEST(UndecidedText, OfAnOlderStoreIsTheEvidence) {
  ClaimPart part = asked(1.8, std::nullopt);
  part.measure = "order", part.verdict = PartVerdict::inconclusive, part.found = {{"order of 'a'", 1.97}};
  part.evidence = "order of 'a' (±0.28) = 1.97 (asked: at least 1.8, but an interval reaches across)";
  EXPECT_EQ(undecided_text(part), part.evidence);
}

/// The number is 0.5, 0.3 to 0.7; the other one lies nearer to the bound but has no range.
TEST(UndecidedText, NamesTheNumberWhoseIntervalReachesAcross) {
  ClaimPart part = asked(std::nullopt, 0.6);
  part.measure = "cost-ratio", part.verdict = PartVerdict::inconclusive;
  part.found = {{"cost of 'a' over 'b' at l2 1e-02", 0.5, 0.3, 0.7}, {"cost of 'a' over 'b' at l2 1e-03", 0.55}};
  part.evidence = "(asked: at most 0.6, but an interval reaches across)";
  EXPECT_THAT(undecided_text(part), HasSubstr("at l2 1e-02 = 0.5 (0.3 to 0.7). More rounds in one session might"));
  part.measure = "error", part.found[0].what = "l2 of 'a' at cells = 8";
  EXPECT_THAT(undecided_text(part), HasSubstr("= 0.5 (0.3 to 0.7). Other replicates might lie"));
  part.measure = "order", part.found = {{"order of 'a'", 0.5, 0.3, 0.7, "finest segment 1.41"}};
  EXPECT_THAT(undecided_text(part), HasSubstr("order of 'a' = 0.5 ± 0.2 (finest segment 1.41). Other points"));
  part.measure = "limit",
  part.found = {{"limit of 'a'", 0.5, 0.3, HUGE_VAL, "only 25 steps at 0.5, where growth shows"}};
  EXPECT_THAT(undecided_text(part), HasSubstr("Longer runs (end_time) might decide: so few steps do not count."));
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

TEST(UndecidedText, OfABracketAsksForAFinerSearch) {
  for (const auto& found : {limit(0.4375, 0.4401), limit(0.4401, 0.4375)}) {
    const ClaimPart part = judged_limits({found}, 0.439);
    ASSERT_EQ(part.verdict, PartVerdict::inconclusive);
    EXPECT_EQ(part.found[0].lower, 0.4375);
    EXPECT_EQ(part.found[0].upper, 0.4401);
    EXPECT_THAT(undecided_text(part), HasSubstr("= 0.4388. A finer search might decide."));
  }
}

/// That of 'b' lies nearer to the bound, but it is 'a' that may lie anywhere beyond it.
TEST(UndecidedText, OfALimitBeyondAllValuesTriedAsksForMore) {
  const ClaimPart part = judged_limits({limit_above_one(), limit(1.1, 1.15)}, 1.2);
  ASSERT_EQ(part.verdict, PartVerdict::inconclusive);
  EXPECT_EQ(part.found[0].lower, 1);
  EXPECT_EQ(part.found[0].upper, HUGE_VAL);
  EXPECT_THAT(undecided_text(part), HasSubstr("limit of 'a', stable at all values tried, up to 1 = 1 or more. A search "
                                              "beyond the values tried might decide."));
}

TEST(CountText, SaysHowManyStudiesWereNotRun) {
  claims::Claim claim;
  EXPECT_EQ(count_text(claim), "not judged yet");
  claim.parts = {{"small", asked(1, std::nullopt)}};
  claim.parts[0].part.verdict = PartVerdict::holds;
  claim.studies = {"small"};
  EXPECT_EQ(count_text(claim), "its criterion holds");
  claim.not_run = {"long"};
  EXPECT_EQ(count_text(claim), "its criterion holds; 1 of its 2 studies was not run");
  claim.not_run = {"long", "longer"};
  EXPECT_EQ(count_text(claim), "its criterion holds; 2 of its 3 studies were not run");
}

/// A criterion that was asked when its number was known is weaker evidence.
TEST(CountText, SaysHowManyCriteriaCameAfterARun) {
  claims::Claim claim;
  const auto add = [&claim](const std::string& statement, PartVerdict verdict) {
    claim.parts.push_back({"small", asked(1, std::nullopt)});
    claim.parts.back().part.statement = statement, claim.parts.back().part.verdict = verdict;
  };
  add("it falls (bounds set after a run)", PartVerdict::holds);
  EXPECT_EQ(count_text(claim), "its criterion holds, set after a run");
  add("it rises (asked after a run)", PartVerdict::fails);
  EXPECT_EQ(count_text(claim), "1 of 2 criteria hold, all set after a run");
  add("it stays", PartVerdict::holds);
  add("it is drawn", PartVerdict::shown);
  EXPECT_EQ(count_text(claim), "2 of 3 criteria hold; 2 of them set after a run");
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

ClaimPart holding(const std::string& what, double value, double at_least) {
  ClaimPart part = asked(at_least, std::nullopt);
  part.verdict = PartVerdict::holds, part.found = {{what, value}};
  return part;
}

TEST(DecidingText, NamesTheStudyWhereSeveralJudgeTheClaim) {
  claims::Claim claim;
  claim.parts = {{"one", holding("order of 'a'", 2, 1)}, {"one", holding("order of 'b'", 1.5, 1)}};
  EXPECT_EQ(deciding_text(claim), "order of 'b': 1.5 (asked: at least 1)");
  claim.parts[0].study = "two";
  EXPECT_EQ(deciding_text(claim), "order of 'b': 1.5 (asked: at least 1; study one)");
  claim.parts[0].part.statement = "first order", claim.parts[0].part.verdict = PartVerdict::inconclusive;
  EXPECT_EQ(deciding_text(claim), "first order: inconclusive; study two");
}

TEST(DecidingText, IsOfANumberOnItsBoundOnlyWhereThereIsNoOther) {
  claims::Claim claim;
  claim.parts = {{"one", holding("stable of 'a'", 1, 1)}, {"one", holding("order of 'a'", 1.5, 1)}};
  EXPECT_EQ(deciding_text(claim), "order of 'a': 1.5 (asked: at least 1)");
  claim.parts.pop_back();
  EXPECT_EQ(deciding_text(claim), "stable of 'a': 1 (asked: at least 1)");
}

TEST(DecidingText, IsACriterionsStatementWhereNoNumberWasCompared) {
  records::ClaimPart part;
  part.statement = "the difference is subtle", part.measure = "awaited";
  part.verdict = PartVerdict::inconclusive;
  claims::Claim claim;
  claim.parts = {{"a-study", part}};
  EXPECT_EQ(deciding_text(claim), "the difference is subtle: inconclusive");
  claim.parts[0].part.verdict = PartVerdict::holds;
  EXPECT_EQ(deciding_text(claim), "");
}

TEST(DecidingText, NamesNoNumberThatLeavesNothingOpen) {
  ClaimPart part = asked(0.5, 2);
  part.statement = "first order", part.verdict = PartVerdict::inconclusive;
  part.found = {{"order of 'a'", 1, 0.9, 1.1}};
  claims::Claim claim;
  claim.parts = {{"a-study", part}};
  EXPECT_EQ(deciding_text(claim), "first order: inconclusive") << "a series could not be run";
  claim.parts[0].part.found = {{"order of 'a'", 3, 2.9, 3.1}};
  EXPECT_EQ(deciding_text(claim), "first order: inconclusive") << "nor here, where it lies beyond them";
  claim.parts[0].part.found = part.found;
  claim.parts[0].part.found[0].upper = 2.5;
  EXPECT_THAT(deciding_text(claim), HasSubstr("order of 'a': 1 (0.9 to 2.5) (asked: 0.5 to 2; inconclusive)"));
  claim.parts[0].part.withheld = "made with --set: ppc = 4 in 1 of 1 series";
  EXPECT_EQ(deciding_text(claim), "first order: inconclusive");
  EXPECT_EQ(undecided_text(claim.parts[0].part), "made with --set: ppc = 4 in 1 of 1 series");
}

}  // namespace mpmvv::reports::criteria_test
