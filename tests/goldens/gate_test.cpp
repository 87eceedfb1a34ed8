#include "goldens/gate.hpp"

#include <fmt/format.h>

#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"
#include "tests/goldens/healthy_study.hpp"
#include "tests/numbers.hpp"

namespace mpmvv::goldens::gate_test {

using records::Point;
using support::not_measured;

using namespace healthy_study;
using testing::AllOf;
using testing::HasSubstr;

TEST(Gate, AnOrderWithoutAWindowIsThatOfTheOnlyOne) {
  const auto with_another = [](StudyResult& s) {
    s.series[0].orders.insert(s.series[0].orders.begin(), s.series[0].orders[0]);
    s.series[0].orders[0].to = 32;
  };
  const GateResult result = judge(order_two, with_another);
  EXPECT_EQ(result.verdict, Verdict::inconclusive) << "the first one is not always meant";
  EXPECT_THAT(result.reason, HasSubstr("'a' has orders in l2 over several windows"));
  OrderGolden golden{"a", "l2", 2, 1.85, 2.15, {16, 64}};
  EXPECT_EQ(judge(Golden{"s", "s.toml:9", golden}, with_another).verdict, Verdict::pass);
}

TEST(Gate, AHealthyStudyPassesEverything) {
  const GateReport report = run_gate({order_two, error_at_64, limit_of_a, small_value, stable_at_64}, {healthy()});
  for (const GateResult& result : report.results) {
    EXPECT_EQ(result.verdict, Verdict::pass) << result.name << ": " << result.reason;
    EXPECT_EQ(result.reason, "");
  }
  EXPECT_EQ(report.exit_code(), 0);
  EXPECT_EQ(report.results[0].name, "order of 'a' in l2");
  EXPECT_EQ(report.results[0].expected, "2 in [1.85, 2.15]");
  EXPECT_EQ(report.results[0].measured, "2 (3 points)");
}

TEST(Gate, WhatNobodyHasReviewedDoesNotPass) {
  Golden golden = order_two;
  golden.reviewed = false;
  const GateReport report = run_gate({golden}, {healthy()});
  EXPECT_EQ(report.exit_code(), 3);
  EXPECT_EQ(report.results[0].measured, "2 (3 points)");
  EXPECT_THAT(report.results[0].reason, HasSubstr("not reviewed"));
  golden.expectation = OrderGolden{"a", "l2", 3, 2.85, 3.15};
  EXPECT_EQ(run_gate({golden}, {healthy()}).exit_code(), 1) << "it can fail";
}

TEST(Gate, ATrialDecidesNothingUnlessItIsAskedFor) {
  StudyResult study = healthy();
  study.text = store::with_trial("title = \"S\"", "shuffle = 3 in 1 of 1 series");
  const Golden three{"s", "", OrderGolden{"a", "l2", 3, 2.85, 3.15}};
  for (const Golden& golden : {order_two, three}) {
    const GateReport report = run_gate({golden}, {study});
    EXPECT_EQ(report.exit_code(), 3);
    EXPECT_EQ(report.results[0].reason, "made with --set: shuffle = 3 in 1 of 1 series");
    EXPECT_EQ(report.results[0].measured, "2 (3 points)");
  }
  EXPECT_EQ(run_gate({order_two}, {study}, {.trials = Trials::judged}).exit_code(), 0);
  EXPECT_EQ(run_gate({three}, {study}, {.trials = Trials::judged}).exit_code(), 1);
}

TEST(Gate, ErrorsFailWhenWorseAndWhenBetter) {
  EXPECT_EQ(judge_error(1.09e-4).verdict, Verdict::pass);
  EXPECT_EQ(judge_error(0.91e-4).verdict, Verdict::pass);
  EXPECT_EQ(judge_error(1.11e-4).verdict, Verdict::fail);
  EXPECT_EQ(judge_error(INFINITY).verdict, Verdict::fail);
  const GateResult better = judge_error(0.89e-4);
  EXPECT_EQ(better.verdict, Verdict::fail);
  EXPECT_EQ(better.reason, "better than the golden: if that was meant, propose a new one");
  EXPECT_EQ(judge_error(not_measured).verdict, Verdict::inconclusive);
}

/// As an energy loss where energy was gained.
TEST(Gate, AnErrorBelowZeroIsNoBetterOne) {
  EXPECT_TRUE(judge_error(0).better);
  for (const double error : {-1e-9, -4.48e-2, -double(INFINITY)}) {
    const GateResult result = judge_error(error);
    EXPECT_EQ(result.verdict, Verdict::fail) << error;
    EXPECT_FALSE(result.better) << error;
    EXPECT_THAT(result.reason, testing::StartsWith("below 0:")) << error;
  }
}

TEST(Gate, AnUnstableOrFailedPointFailsAnErrorGolden) {
  for (const Status status : {Status::unstable, Status::failed}) {
    const GateResult result = judge(error_at_64, [&](StudyResult& s) {
      s.series[0].points[2].status = status;
      s.series[0].points[2].reason = "energy";
    });
    EXPECT_EQ(result.verdict, Verdict::fail);
    EXPECT_EQ(result.measured, "");
    EXPECT_EQ(result.reason,
              status == Status::failed ? "the run at 64 failed: energy" : "the run at 64 is unstable: energy");
    EXPECT_EQ(result.cause, "energy");
  }
}

TEST(Gate, WhatWasNotMeasuredIsNoNumber) {
  const GateResult value = judge(small_value, [](StudyResult& s) { s.values[0].value = not_measured; });
  for (const GateResult& result :
       {judge_error(not_measured), judge_order(not_measured), judge_order(not_measured, 1), value})
    EXPECT_EQ(result.measured, "") << result.name;
  EXPECT_EQ(measured_text(value), "") << "its reason says it";
  EXPECT_EQ(measured_text(judge_order(not_measured, 1)), ", not measured");
  EXPECT_EQ(measured_text(judge_error(2e-4)), ", measured 0.0002");
}

TEST(Gate, AnOrderSaysWhatBecameOfTheRunsThatItLacks) {
  OrderGolden golden{"a", "l2", 2, 1.85, 2.15, {16, 64}, 3};
  golden.finest = {32, 4e-4};
  const auto with = [&golden](int points, double order) {
    return judge(Golden{"s", "s.toml:9", golden}, [&](StudyResult& s) {
      records::Series& series = s.series[0];
      series.orders[0].points = points, series.orders[0].order = order;
      for (Point& point : series.points) point.status = Status::failed, point.reason = fmt::format("crash {}", point.x);
      if (points == 2) series.points[0].status = series.points[2].status = Status::ok;
    });
  };
  const GateResult none = with(0, not_measured), some = with(2, 1.9);
  EXPECT_EQ(none.verdict, Verdict::fail);
  EXPECT_EQ(none.measured, "");
  EXPECT_EQ(none.reason, "the runs at 16, 32 and 64 failed; at 32: crash 32") << "as the golden of its error says";
  EXPECT_EQ(none.cause, "crash 32");
  EXPECT_EQ(some.measured, "1.9 (2 points, 1 unstable or failed)");
  EXPECT_EQ(some.reason, "fewer usable points than 3: the run at 32 failed: crash 32");
}

TEST(Gate, SweptValuesMatchUpToRoundOff) {
  EXPECT_EQ(judge(error_at_64, [](StudyResult& s) { s.series[0].points[2].x *= 1 + 1e-15; }).verdict, Verdict::pass);
  EXPECT_EQ(judge(error_at_64, [](StudyResult& s) { s.series[0].points[2].x = 65; }).verdict, Verdict::inconclusive);
}

TEST(Gate, ALimitIsJudgedByItsBracket) {
  EXPECT_EQ(judge_limit(bracket(0.753, 0.759)).verdict, Verdict::fail);
  EXPECT_EQ(judge_limit(bracket(0.70, 0.707)).verdict, Verdict::fail);
  EXPECT_EQ(judge_limit(bracket(0.85, 0.858)).verdict, Verdict::fail);
  EXPECT_EQ(judge_limit(bracket(0.75, 0.765)).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge_limit(bracket(0.755, 0.77)).verdict, Verdict::pass);
  EXPECT_EQ(judge_limit(bracket(0.707, 0.70)).verdict, Verdict::fail);
  EXPECT_EQ(judge_limit(bracket(0.804, 0.798)).verdict, Verdict::pass);
  EXPECT_EQ(judge_limit(bracket(0.77, 0.845)).verdict, Verdict::pass) << "replicates' bracket, within the band's width";
  EXPECT_EQ(judge_limit(bracket(0.75, 0.85)).verdict, Verdict::inconclusive) << "a bracket wider than the band";
}

TEST(Gate, ALimitThatIsNotMonotoneIsJudgedByItsWholeBracket) {
  StabilityLimit limit = bracket(0.785, 0.83);
  limit.monotone = false;
  EXPECT_EQ(judge_limit(limit).verdict, Verdict::pass);
  EXPECT_EQ(judge_limit(limit).measured, "0.8075 in [0.785, 0.83], not monotone");
  limit.unstable = 1.2;
  EXPECT_EQ(judge_limit(limit).verdict, Verdict::inconclusive);
}

/// What a search of [low, high] finds where all runs are stable, or none is.
StabilityLimit unfound(double low, double high, bool is_stable, bool stable_below) {
  return fits::find_limit({.key = "k", .from = low, .to = high, .scan_ratio = 10, .stable_below = stable_below},
                          [=](const std::vector<double>& values) {
                            std::vector<fits::Probe> probes;
                            for (const double value : values) probes.push_back({value, is_stable, ""});
                            return probes;
                          });
}

TEST(Gate, ALimitOfWhichOneEndIsKnownFailsWhenItLiesBeyondTheBand) {
  const auto judged = [](double low, double high, bool is_stable, bool stable_below) {
    return judge_limit(unfound(low, high, is_stable, stable_below));
  };
  for (const double low : {0.1, 0.8}) {
    const GateResult calm = judged(low, 0.9, true, true);
    EXPECT_EQ(calm.verdict, Verdict::fail);
    EXPECT_EQ(calm.measured, "above 0.9");
    EXPECT_TRUE(calm.better);
  }
  const GateResult wild = judged(0.7, 0.8, false, true);
  EXPECT_EQ(wild.verdict, Verdict::fail);
  EXPECT_EQ(wild.measured, "below 0.7");
  EXPECT_FALSE(wild.better);
  EXPECT_TRUE(judged(0.7, 0.8, true, false).better) << "stable with less smoothing";
  EXPECT_FALSE(judged(0.8, 0.9, false, false).better);
  EXPECT_EQ(judged(0.1, 0.83, true, true).verdict, Verdict::inconclusive) << "the limit may lie in the band";
  EXPECT_EQ(judged(0.8, 0.9, false, true).verdict, Verdict::inconclusive);
  EXPECT_EQ(judged(0.1, 0.83, true, true).reason, "limit not found: stable at all values tried, up to 0.83");
  EXPECT_EQ(judge_limit({}).reason, "limit not found: nothing tried");
}

TEST(Gate, ValuesAreHeldAgainstTheirBounds) {
  const auto judge_value = [](const ValueGolden& golden, double value) {
    return judge({"s", "", golden}, [&](StudyResult& s) { s.values[0].value = value; }).verdict;
  };
  const ValueGolden at_most{.name = "gap", .upper = 1}, at_least{.name = "gap", .lower = 1}, both{"gap", 1, 2};
  EXPECT_EQ(judge_value(at_most, -7), Verdict::pass);
  EXPECT_EQ(judge_value(at_most, 1.1), Verdict::fail);
  EXPECT_EQ(judge_value(at_least, 7), Verdict::pass);
  EXPECT_EQ(judge_value(at_least, 0.9), Verdict::fail);
  EXPECT_EQ(judge_value(both, 1.5), Verdict::pass);
  EXPECT_EQ(judge_value(both, 2.1), Verdict::fail);
  EXPECT_EQ(judge_value(both, not_measured), Verdict::inconclusive);
  for (const ValueGolden& golden : {at_most, at_least})
    for (const double diverged : {infinity, -infinity}) EXPECT_EQ(judge_value(golden, diverged), Verdict::fail);
}

TEST(Gate, AStatusMustBeTheExpectedOne) {
  const auto judge_status = [](Status expected, Status measured) {
    return judge({"s", "", StatusGolden{"a", 64, expected}},
                 [&](StudyResult& s) { s.series[0].points[2].status = measured; });
  };
  EXPECT_EQ(judge_status(Status::unstable, Status::unstable).verdict, Verdict::pass);
  EXPECT_EQ(judge_status(Status::unstable, Status::ok).verdict, Verdict::fail);
  EXPECT_EQ(judge_status(Status::unstable, Status::failed).verdict, Verdict::fail);
  EXPECT_EQ(judge_status(Status::ok, Status::unstable).verdict, Verdict::fail);
  EXPECT_TRUE(judge_status(Status::unstable, Status::ok).better);
  EXPECT_FALSE(judge_status(Status::ok, Status::unstable).better);
}

TEST(Gate, WhatTheStoreLacksIsInconclusiveAndNamed) {
  const auto expect_missing = [](const GateResult& result, const std::string& what) {
    EXPECT_EQ(result.verdict, Verdict::inconclusive);
    EXPECT_THAT(result.reason, AllOf(testing::StartsWith("missing: "), HasSubstr(what)));
  };
  expect_missing(run_gate({order_two}, {}).results.at(0), "no study 's'");
  expect_missing(judge(order_two, [](StudyResult& s) { s.series.clear(); }), "no series 'a'");
  expect_missing(judge(order_two, [](StudyResult& s) { s.series[0].orders.clear(); }), "no order of 'a' in l2");
  expect_missing(judge(error_at_64, [](StudyResult& s) { s.series[0].points.pop_back(); }), "no point of 'a' at 64");
  expect_missing(judge(error_at_64, [](StudyResult& s) { s.series[0].points[2].y.clear(); }), "no l2 of 'a'");
  expect_missing(judge(stable_at_64, [](StudyResult& s) { s.series[0].points.clear(); }), "no point of 'a' at 64");
  expect_missing(judge(limit_of_a, [](StudyResult& s) { s.series[0].limit.reset(); }), "no limit of 'a'");
  expect_missing(judge(small_value, [](StudyResult& s) { s.values.clear(); }), "no value 'gap'");
}

TEST(Gate, AFailureOutranksWhatIsInconclusive) {
  StudyResult study = healthy();
  study.values.clear();
  EXPECT_EQ(run_gate({order_two, small_value}, {study}).exit_code(), 3);
  study.series[0].orders[0].order = 1;
  const GateReport report = run_gate({order_two, small_value}, {study});
  EXPECT_EQ(report.exit_code(), 1);
  EXPECT_EQ(report.count(Verdict::fail), 1);
  EXPECT_EQ(report.count(Verdict::inconclusive), 1);
}

TEST(Gate, WhatIsTooOldDecidesNothing) {
  const Golden three{"s", "", OrderGolden{"a", "l2", 3, 2.85, 3.15}};
  for (const Golden& golden : {order_two, three}) {
    const GateReport report = run_gate({golden}, {healthy()}, {.outdated = {{"s", "of yesterday"}}});
    EXPECT_EQ(report.exit_code(), 3);
    EXPECT_EQ(report.results[0].reason, "of yesterday");
  }
  EXPECT_EQ(run_gate({order_two}, {healthy()}, {.outdated = {{"t", "of yesterday"}}}).exit_code(), 0);
}

TEST(Gate, OnlyTheNamedStudiesAreJudged) {
  const Golden other{"t", "t.toml:1", ValueGolden{.name = "x", .upper = 1}};
  const GateReport report = run_gate({order_two, other}, {healthy()}, {.only = {"s"}});
  ASSERT_EQ(report.results.size(), 1U);
  EXPECT_EQ(report.results[0].study, "s");
  EXPECT_THROW(run_gate({order_two, other}, {healthy()}, {.only = {"s", "u"}}), support::UsageError);
}

TEST(Gate, AGateThatChecksNothingIsAnError) {
  EXPECT_THROW(run_gate({}, {healthy()}), support::UsageError);
}

}  // namespace mpmvv::goldens::gate_test
