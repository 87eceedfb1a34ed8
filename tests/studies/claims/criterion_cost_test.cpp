#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/studies/claims/criterion_samples.hpp"

/// Criteria on times, which have the range of their repetitions.
namespace mpmvv::claims::criterion_cost_test {

using namespace criterion_samples;
using records::ClaimPart;
using records::PartVerdict;
using records::Point;

using testing::HasSubstr;
using testing::Not;

/// Times 3 + 2 x and 3 + 4 x, and the same numbers as errors. The range of the times of `slow` is this part of them.
StudyResult two_lines(double spread) {
  StudyResult result;
  result.sweep = "order";
  result.series = {Series{"slow", {}, {}, {}}, Series{"steep", {}, {}, {}}};
  for (const double x : {1.0, 3.0}) {
    for (int k = 0; k < 2; ++k) {
      const double y = 3 + (2 + 2 * k) * x;
      result.series[static_cast<std::size_t>(k)].points.push_back(
          {x, Status::ok, "", {{"ns_per_particle_step", y}, {"l2", y}, {"step_seconds_spread", k == 0 ? spread : 0}}});
    }
  }
  return result;
}

Criterion slope(Criterion::Kind kind, double at_least, double at_most) {
  Criterion c = criterion(kind, "slow", at_least, at_most);
  c.over = "steep", c.window = {1, 3}, c.norm = "ns_per_particle_step";
  return c;
}

/// With a range of 20 % the times are 5 ± 0.5 and 9 ± 0.9. The slope is 2 ± hypot(0.5, 0.9) / 2 = 2 ± 0.5148.
TEST(CostCriterion, ASlopeHasTheRangeOfItsTimes) {
  const auto verdict = [](double at_least, double at_most) {
    return judge(slope(Criterion::Kind::slope_ratio, at_least, at_most), two_lines(0.2)).verdict;
  };
  EXPECT_EQ(verdict(0.371, 0.629), PartVerdict::holds) << "0.5 ± 0.1287";
  EXPECT_EQ(verdict(0.372, 1), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0, 0.628), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0.628, 1), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0.629, 1), PartVerdict::fails);
  const ClaimPart part = judge(slope(Criterion::Kind::slope_ratio, 0.4, 1), two_lines(0.2));
  EXPECT_THAT(
      part.evidence,
      HasSubstr(
          "over order 1 to 3 = 0.5 (0.371 to 0.629, not timed in the same rounds) (asked: 0.4 to 1, but an interval "
          "reaches across)"));
  EXPECT_THAT(part.found[0].what, Not(HasSubstr("0.371")));
  EXPECT_EQ(judge(slope(Criterion::Kind::slope_share, 0.212, 0.36), two_lines(0.2)).verdict, PartVerdict::holds)
      << "2 ± 0.5148 over 7";
  EXPECT_EQ(judge(slope(Criterion::Kind::slope_share, 0.213, 0.36), two_lines(0.2)).verdict, PartVerdict::inconclusive);
}

TEST(CostCriterion, TheDivisorWidensTheRange) {
  StudyResult result = two_lines(0.2);
  std::swap(result.series[0].name, result.series[1].name);
  const auto verdict = [&](double at_least, double at_most) {
    return judge(slope(Criterion::Kind::slope_ratio, at_least, at_most), result).verdict;
  };
  EXPECT_EQ(verdict(1.59, 2.70), PartVerdict::holds) << "4 / 2.5148 to 4 / 1.4852";
  EXPECT_EQ(verdict(1.60, 2.70), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(1.59, 2.69), PartVerdict::inconclusive);
}

/// As a divisor an infinite value would make any slope an exact 0.
TEST(CostCriterion, AShareOfAnUnstableValueIsNotKnown) {
  StudyResult result = two_lines(0);
  const auto judged = [&](double at_least, double at_most) {
    Criterion c = slope(Criterion::Kind::slope_share, at_least, at_most);
    c.norm = "l2";
    return judge(c, result);
  };
  ASSERT_EQ(judged(0.28, 0.29).verdict, PartVerdict::holds) << "2 over 7";
  result.series[1].points[1] = {3, Status::unstable, "blown up", {}};
  EXPECT_EQ(judged(0.28, 0.29).verdict, PartVerdict::holds) << "it is divided by the first value";
  result.series[1].points[0] = {1, Status::unstable, "blown up", {}};
  for (const double at_least : {-0.1, 0.1}) {
    const ClaimPart part = judged(at_least, 0.2);
    EXPECT_EQ(part.verdict, PartVerdict::inconclusive);
    EXPECT_THAT(part.evidence, HasSubstr("over order 1 to 3 is not known (asked"));
  }
}

TEST(CostCriterion, WithoutAPointOfTheDivisorNothingIsKnown) {
  StudyResult result = two_lines(0.2);
  result.series[1].points.clear();
  for (const auto kind : {Criterion::Kind::slope_ratio, Criterion::Kind::slope_share}) {
    const ClaimPart part = judge(slope(kind, 0.4, 1), result);
    EXPECT_EQ(part.verdict, PartVerdict::inconclusive);
    EXPECT_THAT(part.evidence, HasSubstr("is not known"));
  }
}

TEST(CostCriterion, WhereTheDivisorMayBe0NothingIsDecided) {
  StudyResult result = two_lines(1);
  std::swap(result.series[0].name, result.series[1].name);
  const ClaimPart part = judge(slope(Criterion::Kind::slope_ratio, 100, 101), result);
  EXPECT_EQ(part.verdict, PartVerdict::inconclusive);
  EXPECT_THAT(part.evidence, HasSubstr("= 2 (without bounds, not timed in the same rounds) (asked"));
}

TEST(CostCriterion, OverASlopeOf0NothingIsDecided) {
  StudyResult result = two_lines(0);
  for (Point& point : result.series[1].points) point.y["l2"] = 3;
  Criterion c = slope(Criterion::Kind::slope_ratio, 100, 101);
  c.norm = "l2", c.at_most.reset();
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::inconclusive) << "in which direction it is infinite is not known";
}

/// Two lines whose times rise and fall together, by a factor of ten, and `noise` of `slow` at x = 1 alone.
StudyResult two_timed_lines(double noise, const std::string& session_of_steep = "one") {
  StudyResult result = two_lines(0.2);
  for (Series& series : result.series)
    for (Point& point : series.points) {
      const double mean = point.y.at("ns_per_particle_step");
      const double own = series.name == "slow" && point.x == 1 ? std::exp(noise) : 1;
      point.rounds = {{mean * own, 10 * mean, mean / own / 10}, series.name == "slow" ? "one" : session_of_steep};
    }
  return result;
}

TEST(CostCriterion, TimesOfTheSameRoundsAreComparedRoundByRound) {
  const Criterion c = slope(Criterion::Kind::slope_ratio, 0.4, 0.6);
  EXPECT_THAT(judge(c, two_timed_lines(0)).evidence, HasSubstr("over order 1 to 3 = 0.5 (asked: 0.4 to 0.6)"));
  const ClaimPart part = judge(c, two_timed_lines(0.01));
  EXPECT_EQ(part.verdict, PartVerdict::holds);
  EXPECT_THAT(part.evidence, HasSubstr("over order 1 to 3 = 0.5 (0.485 to 0.516) (asked"))
      << "without one of two rounds the time is 5 exp(±0.005), and the logarithm of the slope changes by 0.00625";
  EXPECT_EQ(judge(c, two_timed_lines(0.2)).verdict, PartVerdict::inconclusive);
  EXPECT_THAT(judge(c, two_timed_lines(0.01, "another")).evidence,
              HasSubstr("(0.371 to 0.629, not timed in the same rounds)"));
}

/// Without one of the rounds the times of `slow` are 5 exp(0.7) and 9: they fall.
TEST(CostCriterion, WhereTheSignOfTheDivisorDependsOnARoundNothingIsDecided) {
  Criterion c = slope(Criterion::Kind::slope_ratio, 100, 101);
  c.series = {"steep"}, c.over = "slow";
  EXPECT_EQ(judge(c, two_timed_lines(0.01)).verdict, PartVerdict::fails);
  EXPECT_THAT(judge(c, two_timed_lines(1.4)).evidence, HasSubstr("= 2 (without bounds) (asked"));
}

/// The same numbers as errors are what they are.
TEST(CostCriterion, NoOtherNumberHasARange) {
  Criterion c = slope(Criterion::Kind::slope_ratio, 0.4999, 0.5001);
  EXPECT_EQ(judge(c, two_lines(0)).verdict, PartVerdict::holds);
  EXPECT_EQ(judge(c, two_lines(0.2)).verdict, PartVerdict::inconclusive);
  c.norm = "l2";
  EXPECT_EQ(judge(c, two_lines(0.2)).verdict, PartVerdict::holds);
}

/// Two runs each: an error of 0.1 for 1 or 2 s, and of 0.001 for 100 or 400 s. The range is 40 %, or none.
StudyResult two_costs() {
  StudyResult result;
  result.series = {Series{"cheap", {}, {}, {}}, Series{"dear", {}, {}, {}}};
  const auto point = [](double error, double cost, double spread) {
    return Point{1 / error, Status::ok, "", {{"l2", error}, {"step_seconds", cost}, {"step_seconds_spread", spread}}};
  };
  result.series[0].points = {point(0.1, 1, 0.4), point(0.001, 100, 0.4)};
  result.series[1].points = {point(0.1, 2, 0), point(0.001, 400, 0)};
  return result;
}

/// At 0.01 the costs are 10 and 28.28. The range of the first is in squares: 0.2 / √2 = 0.1414 of it.
TEST(CostCriterion, ARatioOfTimesHasTheirRange) {
  const auto verdict = [](double error, std::optional<double> at_least, std::optional<double> at_most) {
    Criterion c = criterion(Criterion::Kind::cost_ratio, "cheap", at_least, at_most);
    c.over = "dear", c.window = {error, error};
    return judge(c, two_costs()).verdict;
  };
  EXPECT_EQ(verdict(0.1, 0.399, 0.601), PartVerdict::holds) << "0.5 ± 0.1";
  EXPECT_EQ(verdict(0.1, {}, 0.599), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0.1, {}, 0.401), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0.1, {}, 0.399), PartVerdict::fails);
  EXPECT_EQ(verdict(0.01, 0.3035, 0.4036), PartVerdict::holds) << "0.3536 ± 0.05";
  EXPECT_EQ(verdict(0.01, 0.3036, 0.4036), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0.01, 0.3035, 0.4035), PartVerdict::inconclusive);
}

/// At 0.01 the cost of `cheap` is the root of the product of its two, in each round.
TEST(CostCriterion, ARatioOfTimesOfTheSameRoundsIsComparedRoundByRound) {
  StudyResult result = two_costs();
  for (Series& series : result.series)
    for (Point& point : series.points) point.rounds = {{1, 20, 3}, "one"};
  result.series[0].points[0].rounds.costs[1] = 20 * std::exp(0.1);
  const auto evidence = [&](double error) {
    Criterion c = criterion(Criterion::Kind::cost_ratio, "cheap", {}, 1);
    c.over = "dear", c.window = {error, error};
    return judge(c, result).evidence;
  };
  EXPECT_THAT(evidence(0.001), HasSubstr("at l2 1e-03 = 0.25 (asked")) << "the same in all rounds";
  EXPECT_THAT(evidence(0.1), HasSubstr("at l2 1e-01 = 0.5 (0.433 to 0.577) (asked")) << "exp(± 4.303 / 3 * 0.1)";
  EXPECT_THAT(evidence(0.01), HasSubstr("at l2 1e-02 = 0.3536 (0.329 to 0.38) (asked")) << "half of that";
  result.series[1].points[1].rounds.session = "another";
  EXPECT_THAT(evidence(0.1), HasSubstr("= 0.5 (0.433 to 0.577)")) << "which this error does not need";
  EXPECT_THAT(evidence(0.01), HasSubstr("= 0.3536 (0.304 to 0.404, not timed in the same rounds)"));
}

TEST(CostCriterion, WhatNeverGetsThereHasNoRange) {
  StudyResult result = two_costs();
  result.series[0].points.pop_back();
  Criterion c = criterion(Criterion::Kind::cost_ratio, "cheap", {}, 1);
  c.over = "dear", c.window = {0.001, 0.001};
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::fails);
  c.series = {"dear"}, c.over = "cheap";
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::holds);
}

/// The series over the other one at errors from 0.001 to 0.1.
ClaimPart cost_ratio(const char* series, const char* over, double from, std::optional<double> at_least,
                     std::optional<double> at_most, const StudyResult& result) {
  Criterion c = criterion(Criterion::Kind::cost_ratio, series, at_least, at_most);
  c.over = over, c.window = {from, 0.1};
  return judge(c, result);
}

/// At 0.001, which neither reaches, nothing is known; at 0.01 and 0.1 the dear one costs 2.8 and 2 times as much.
TEST(CostCriterion, WhereNeitherGetsThereAnotherErrorDecides) {
  StudyResult result = two_costs();
  for (Series& series : result.series) series.points[1].y["l2"] = 0.01;
  const ClaimPart fails = cost_ratio("dear", "cheap", 0.001, {}, 1, result);
  EXPECT_EQ(fails.verdict, PartVerdict::fails);
  EXPECT_THAT(fails.evidence, HasSubstr("at l2 1e-03 is not known (neither ever reaches it) (asked"));
  EXPECT_THAT(fails.found, testing::SizeIs(2)) << "what is not known decides nothing";
  const ClaimPart open = cost_ratio("dear", "cheap", 0.001, 1, {}, result);
  EXPECT_EQ(open.verdict, PartVerdict::inconclusive);
  ASSERT_THAT(open.found, testing::SizeIs(3));
  const auto lost = std::ranges::find(open.found, "neither ever reaches it", &records::Found::remark);
  ASSERT_NE(lost, open.found.end());
  EXPECT_TRUE(std::isnan(lost->value));
}

/// Whatever the other runs say: one that failed might have reached an error, or have done so for less.
TEST(CostCriterion, ARunThatFailedLeavesTheRatioOfCostsOpen) {
  StudyResult result = two_costs();
  result.sweep = "cells";
  result.series[1].points[1] = {1000, Status::failed, "the machine was stopped", {}};
  const ClaimPart part = cost_ratio("cheap", "dear", 0.001, {}, 1, result);
  EXPECT_EQ(part.verdict, PartVerdict::inconclusive);
  EXPECT_THAT(part.evidence, HasSubstr("at l2 1e-01 = 0.5 (0.4 to 0.6, not timed in the same rounds); "));
  EXPECT_THAT(part.evidence, HasSubstr("at l2 1e-03 is not known; 'dear' failed at cells = 1000 (asked"));
  EXPECT_THAT(part.evidence, Not(HasSubstr("never reaches it")));
  EXPECT_EQ(cost_ratio("dear", "cheap", 0.001, {}, 1, result).verdict, PartVerdict::inconclusive);
  EXPECT_EQ(cost_ratio("cheap", "dear", 0.1, {}, 1, result).verdict, PartVerdict::inconclusive)
      << "at an error that a sound run reaches";
  result.series[0].points.clear();
  result.series[1].points[0].status = Status::failed;
  EXPECT_THAT(cost_ratio("cheap", "dear", 0.1, 1, {}, result).evidence,
              HasSubstr("1e-01 is not known; no cost of 'cheap'; 'dear' failed at cells = 10, 1000 (asked"));
}

TEST(CostCriterion, SaysWhoseTimeIsThatOfTheWholeProcess) {
  StudyResult result = two_costs();
  result.series[0].code = records::OtherCode{"my-code", "1.3", "", ""};
  EXPECT_EQ(cost_ratio("cheap", "dear", 0.1, {}, 1, result).found.at(0).remark,
            "not timed in the same rounds, 'cheap': time of the whole process");
  EXPECT_EQ(cost_ratio("dear", "dear", 0.1, {}, 1, result).found.at(0).remark, "");
}

TEST(CostCriterion, ARunThatFailedDoesNotHideThatAnotherSeriesFails) {
  StudyResult result = two_costs();
  result.series.push_back(result.series[1]);
  result.series[2].name = "lost";
  result.series[2].points[1] = {1000, Status::failed, "the machine was stopped", {}};
  Criterion c = criterion(Criterion::Kind::cost_ratio, "dear", {}, 1);
  c.series.emplace_back("lost"), c.over = "cheap", c.window = {0.1, 0.1};
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::fails);
  c.at_most = 3;
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::inconclusive);
}

}  // namespace mpmvv::claims::criterion_cost_test
