#include "goldens/gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::goldens {
namespace gate_test {

using fits::StabilityLimit;
using records::Point;
using records::Status;
using records::StudyResult;
using support::not_measured;

using testing::AllOf;
using testing::HasSubstr;

const Golden order_two{"s", "s.toml:1", OrderGolden{"a", "l2", 2, 1.85, 2.15}};
const Golden error_at_64{"s", "s.toml:2", ErrorGolden{"a", "l2", 64, 1e-4, 0.1}};
const Golden limit_of_a{"s", "s.toml:3", LimitGolden{"a", 0.8, 0.05}};
const Golden small_value{"s", "s.toml:4", ValueGolden{.name = "gap", .upper = 1e-14}};
const Golden stable_at_64{"s", "s.toml:5", StatusGolden{"a", 64, Status::ok}};

StabilityLimit bracket(double stable, double unstable) {
  StabilityLimit limit;
  limit.stable = stable;
  limit.unstable = unstable;
  limit.found = true;
  return limit;
}

/// A study that passes all goldens above.
StudyResult healthy() {
  records::Series a;
  a.name = "a";
  a.points = {{16, Status::ok, "", {{"l2", 1.6e-3}}},
              {32, Status::ok, "", {{"l2", 4e-4}}},
              {64, Status::ok, "", {{"l2", 1e-4}}}};
  a.orders.resize(1);
  a.orders[0].norm = "l2";
  a.orders[0].from = 16;
  a.orders[0].to = 64;
  a.orders[0].points = 3;
  a.orders[0].order = 2;
  a.limit = bracket(0.798, 0.804);
  StudyResult study;
  study.name = "s";
  study.series = {a};
  study.values = {{"gap", 2e-16, ""}};
  return study;
}

GateResult judge(const Golden& golden, const std::function<void(StudyResult&)>& change) {
  StudyResult study = healthy();
  change(study);
  return run_gate({golden}, {study}).results.at(0);
}

GateResult judge_order(double order, int points = 5) {
  return judge(order_two, [&](StudyResult& s) {
    s.series[0].orders[0].order = order;
    s.series[0].orders[0].points = points;
  });
}

GateResult judge_error(double error) {
  return judge(error_at_64, [&](StudyResult& s) { s.series[0].points[2].y["l2"] = error; });
}

GateResult judge_limit(const StabilityLimit& limit) {
  return judge(limit_of_a, [&](StudyResult& s) { s.series[0].limit = limit; });
}

TEST(Gate, AnOrderIsThatOfItsWindowAndOfAllItsPoints) {
  const auto golden = [](std::vector<double> window, int points) {
    return Golden{"s", "s.toml:9", OrderGolden{"a", "l2", 2, 1.85, 2.15, std::move(window), points}};
  };
  const auto unchanged = [](StudyResult&) {};
  EXPECT_EQ(judge(golden({16, 64}, 3), unchanged).verdict, Verdict::pass);
  EXPECT_EQ(judge(golden({8, 64}, 3), unchanged).verdict, Verdict::inconclusive) << "another window";
  EXPECT_EQ(judge(golden({16, 64}, 4), unchanged).verdict, Verdict::fail) << "a point was lost";
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

TEST(Gate, OrdersFailOnEitherSideOfTheBand) {
  EXPECT_EQ(judge_order(1.85).verdict, Verdict::pass);
  EXPECT_EQ(judge_order(1.84).verdict, Verdict::fail);
  EXPECT_EQ(judge_order(2.16).verdict, Verdict::fail);
  EXPECT_EQ(judge_order(40).verdict, Verdict::fail);
  EXPECT_EQ(judge_order(-2).verdict, Verdict::fail);
}

GateResult judge_interval(double order, double half_width, const OrderGolden& golden = {"a", "l2", 2, 1.85, 2.15}) {
  return judge(Golden{"s", "s.toml:9", golden}, [&](StudyResult& s) {
    s.series[0].orders[0].order = order;
    s.series[0].orders[0].half_width = half_width;
  });
}

TEST(Gate, AnOrderFailsWhenItsWholeIntervalLeavesTheBand) {
  EXPECT_EQ(judge_interval(1.7, 0.1).verdict, Verdict::fail);
  EXPECT_EQ(judge_interval(1.7, 0.2).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge_interval(2.3, 0.1).verdict, Verdict::fail);
  EXPECT_EQ(judge_interval(2.3, 0.2).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge_interval(4, 3).verdict, Verdict::fail) << "absurdly high, whatever its interval";
}

TEST(Gate, AWideIntervalDecidesNothingUnlessItWasReviewed) {
  EXPECT_EQ(judge_interval(2, 0.29).verdict, Verdict::pass);
  EXPECT_EQ(judge_interval(2, 0.31).verdict, Verdict::inconclusive);
  OrderGolden golden{"a", "l2", 2, 1.85, 2.15};
  golden.interval = 0.4;
  EXPECT_EQ(judge_interval(2, 0.59, golden).verdict, Verdict::pass);
  EXPECT_EQ(judge_interval(2, 0.61, golden).verdict, Verdict::inconclusive);
}

TEST(Gate, IntervalsOfReplicatesComeBeforeThoseOfResiduals) {
  const GateResult result = judge(Golden{"s", "s.toml:9", OrderGolden{"a", "l2", 2, 1.85, 2.15}}, [](StudyResult& s) {
    s.series[0].orders[0].order = 1.7;
    s.series[0].orders[0].half_width = 1;
    s.series[0].orders[0].replicates = fits::ReplicateFit{12, 0.01, 0.02, 0.5};
  });
  EXPECT_EQ(result.verdict, Verdict::fail);
}

TEST(Gate, AWindowThatWasAsymptoticHasToStaySo) {
  OrderGolden golden{"a", "l2", 2, 1.85, 2.15};
  golden.asymptotic = true;
  const auto with = [&](double last_segment) {
    return judge(Golden{"s", "s.toml:9", golden},
                 [&](StudyResult& s) {
                   s.series[0].orders[0].segments = {{8, 16, 1}, {16, 32, 2}, {32, 64, last_segment}};
                 })
        .verdict;
  };
  EXPECT_EQ(with(2.1), Verdict::pass);
  EXPECT_EQ(with(1.65), Verdict::pass) << "just not asymptotic is no alarm";
  EXPECT_EQ(with(1.5), Verdict::inconclusive);
}

TEST(Gate, AnErrorThatGrowsFailsThoughTheOrderHolds) {
  OrderGolden golden{"a", "l2", 2, 1.85, 2.15};
  golden.finest = {64, 1e-3};
  const auto with = [&](double error) {
    return judge(Golden{"s", "s.toml:9", golden}, [&](StudyResult& s) {
      for (Point& point : s.series[0].points)
        if (point.x == 64) point.y["l2"] = error;
    });
  };
  EXPECT_EQ(with(1.09e-3).verdict, Verdict::pass);
  EXPECT_EQ(with(0.5e-3).verdict, Verdict::pass) << "an error golden's matter";
  EXPECT_EQ(with(1.11e-3).verdict, Verdict::fail);
  EXPECT_NE(with(1.11e-3).reason.find("the order holds, but"), std::string::npos);
}

/// A golden of every form beside a fit over three points of [16, 64], after a change of the points.
GateResult judge_levels(const OrderGolden& golden, const std::function<void(std::vector<Point>&)>& change) {
  return judge(Golden{"s", "s.toml:9", golden}, [&](StudyResult& s) {
    s.series[0].points.insert(s.series[0].points.begin() + 2, {48, Status::ok, "", {{"l2", 2e-4}}});
    change(s.series[0].points);
  });
}

TEST(Gate, WhatIsMissingOrUnstableAtANamedLevelNeverPasses) {
  const auto golden = [](std::vector<double> window, int points, std::vector<double> finest) {
    OrderGolden g{"a", "l2", 2, 1.85, 2.15, std::move(window), points};
    g.finest = std::move(finest);
    return g;
  };
  const auto unstable = [](std::size_t k) { return [k](auto& points) { points[k].status = Status::unstable; }; };
  const auto absent = [](std::size_t k) {
    return [k](auto& points) { points.erase(points.begin() + static_cast<long>(k)); };
  };
  const auto unmeasured = [](auto& points) { points[3].y["l2"] = not_measured; };
  const auto elsewhere = [](auto& points) { points[3].y = {{"linf", 1e-4}}; };
  const auto unchanged = [](auto&) {};
  // Of the four points three are usable in each case below, as a fit over three says.
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {64, 1e-4}), unstable(2)).verdict, Verdict::pass) << "no golden names 48";
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {}), unstable(3)).verdict, Verdict::pass) << "reviewed with a lost point";
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {64, 1e-4}), unstable(3)).verdict, Verdict::fail);
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {64, 1e-4}), unmeasured).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {64, 1e-4}), elsewhere).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {128, 1e-9}), unchanged).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {}), absent(0)).verdict, Verdict::inconclusive) << "the coarser end";
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {}), absent(3)).verdict, Verdict::inconclusive) << "the finer end";
  EXPECT_EQ(judge_levels(golden({16, 64}, 0, {}), absent(3)).verdict, Verdict::inconclusive);
  for (const auto& window : {std::vector<double>{16, 64}, std::vector<double>{}}) {
    EXPECT_EQ(judge_levels(golden(window, 0, {}), unstable(0)).verdict, Verdict::fail);
    EXPECT_EQ(judge_levels(golden(window, 0, {}), unstable(3)).verdict, Verdict::fail);
    EXPECT_EQ(judge_levels(golden(window, 0, {}), absent(2)).verdict, Verdict::pass);
    EXPECT_EQ(judge_levels(golden(window, 0, {}), absent(0)).verdict, Verdict::inconclusive);
  }
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {128, 1e-9}), unchanged).reason, "missing: no point of 'a' at 128");
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {64, 1e-4}), unstable(3)).reason, "no error at 64: the run is not ok");
}

TEST(Gate, AnOrderThatIsBetterForALackOfLevelsIsNone) {
  const GateResult result = judge(Golden{"s", "", OrderGolden{"a", "l2", 1, 0.85, 1.15, {16, 64}}},
                                  [](StudyResult& s) { s.series[0].points.pop_back(); });
  EXPECT_EQ(result.verdict, Verdict::inconclusive);
  EXPECT_EQ(result.reason, "missing: no point of 'a' at 64");
  EXPECT_FALSE(result.better);
}

TEST(Gate, ACurvesWindowNeedsNoPointsAtItsEnds) {
  const auto with = [](double from, double finest) {
    OrderGolden golden{"a", "y", 2, 1.85, 2.15, {from, 70}};
    golden.finest = {finest, 1e-4};
    return judge(Golden{"s", "", golden},
                 [&](StudyResult& s) {
                   s.series[0].orders[0].norm = "y";
                   s.series[0].orders[0].from = from;
                   s.series[0].orders[0].to = 70;
                   for (Point& point : s.series[0].points) point.y = {{"y", 1e-4}};
                 })
        .verdict;
  };
  EXPECT_EQ(with(15, 64), Verdict::pass);
  EXPECT_EQ(with(15, 60), Verdict::inconclusive) << "the finest level is one";
}

TEST(Gate, AnOrderIsThatOfItsOwnNormAndBothEndsOfItsWindow) {
  const auto judged = [](const std::string& norm, double from, double to) {
    return judge(Golden{"s", "", OrderGolden{"a", norm, 2, 1.85, 2.15, {from, to}}}, [](StudyResult& s) {
      records::Series& a = s.series[0];
      for (const double x : {8, 128}) a.points.push_back({x, Status::ok, "", {}});
      for (Point& point : a.points) point.y = {{"l1", 1e-4}, {"l2", 1e-4}};
      a.orders.assign(5, a.orders[0]);
      constexpr std::array<double, 5> starts{16, 16, 8, 8, 16}, ends{64, 128, 64, 128, 64};
      for (std::size_t k = 0; k < 5; ++k) {
        a.orders[k].from = starts[k], a.orders[k].to = ends[k];
        a.orders[k].points = 5;
        a.orders[k].order = 1.9 + 0.05 * static_cast<double>(k);
        a.orders[k].norm = k == 4 ? "l1" : "l2";
      }
    });
  };
  EXPECT_EQ(judged("l2", 16, 64).measured, "1.9 (5 points)");
  EXPECT_EQ(judged("l2", 16, 128).measured, "1.95 (5 points)");
  EXPECT_EQ(judged("l2", 8, 64).measured, "2 (5 points)");
  EXPECT_EQ(judged("l2", 8, 128).measured, "2.05 (5 points)");
  EXPECT_EQ(judged("l1", 16, 64).measured, "2.1 (5 points)");
  EXPECT_EQ(judged("l2", 32, 64).verdict, Verdict::inconclusive);
  EXPECT_EQ(judged("linf", 16, 64).verdict, Verdict::inconclusive);
}

TEST(Gate, OnlySegmentsInsideTheWindowScatter) {
  OrderGolden golden{"a", "l2", 2, 1.85, 2.15};
  golden.asymptotic = true;
  const auto with = [&](double before, double after, bool asymptotic) {
    golden.asymptotic = asymptotic;
    return judge(Golden{"s", "", golden},
                 [&](StudyResult& s) {
                   s.series[0].orders[0].segments = {{8, 16, before}, {16, 32, 2}, {32, 64, 2.1}, {64, 128, after}};
                 })
        .verdict;
  };
  EXPECT_EQ(with(0, 2, true), Verdict::pass);
  EXPECT_EQ(with(2, 0, true), Verdict::pass);
  const auto inside = [&](bool asymptotic) {
    golden.asymptotic = asymptotic;
    return judge(Golden{"s", "", golden},
                 [&](StudyResult& s) {
                   s.series[0].orders[0].segments = {{16, 32, 2}, {32, 64, 9}};
                 })
        .verdict;
  };
  EXPECT_EQ(inside(true), Verdict::inconclusive);
  EXPECT_EQ(inside(false), Verdict::pass) << "it never was asymptotic";
}

TEST(Gate, TheBetterSideIsNamed) {
  const auto order = [](double measured) { return judge_order(measured).better; };
  EXPECT_TRUE(order(2.3));
  EXPECT_FALSE(order(1.5));
  EXPECT_FALSE(order(40)) << "absurd";
  EXPECT_TRUE(judge_error(0.5e-4).better);
  EXPECT_FALSE(judge_error(2e-4).better);
  const auto limit = [](const char* key, double stable, double unstable) {
    StabilityLimit found = bracket(stable, unstable);
    found.key = key;
    const GateResult result = judge_limit(found);
    EXPECT_EQ(result.verdict, Verdict::fail);
    return result.better;
  };
  EXPECT_TRUE(limit("cfl", 0.9, 0.905)) << "stable for larger steps";
  EXPECT_FALSE(limit("cfl", 0.7, 0.705));
  EXPECT_TRUE(limit("smoothing_length", 0.705, 0.7)) << "stable with less smoothing";
  EXPECT_FALSE(limit("smoothing_length", 0.905, 0.9));
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
  EXPECT_EQ(run_gate({order_two}, {study}, {}, Trials::judged).exit_code(), 0);
  EXPECT_EQ(run_gate({three}, {study}, {}, Trials::judged).exit_code(), 1);
}

TEST(Gate, OrdersWithoutEvidenceAreInconclusive) {
  EXPECT_EQ(judge_order(not_measured).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge_order(2, 2).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge_order(9, 2).verdict, Verdict::inconclusive);
}

TEST(Gate, PointsLostFromTheWindowAreShown) {
  const GateResult result = judge(order_two, [](StudyResult& s) {
    s.series[0].points[0].status = Status::failed;
    s.series[0].points[1].status = Status::unstable;
  });
  EXPECT_EQ(result.measured, "2 (3 points, 2 unstable or failed)");
  const GateResult outside = judge(order_two, [](StudyResult& s) {
    s.series[0].points.push_back({128, Status::unstable, "", {}});
  });
  EXPECT_EQ(outside.measured, "2 (3 points)");
}

TEST(Gate, ErrorsFailWhenWorseAndWhenBetter) {
  EXPECT_EQ(judge_error(1.09e-4).verdict, Verdict::pass);
  EXPECT_EQ(judge_error(0.91e-4).verdict, Verdict::pass);
  EXPECT_EQ(judge_error(1.11e-4).verdict, Verdict::fail);
  EXPECT_EQ(judge_error(INFINITY).verdict, Verdict::fail);
  const GateResult better = judge_error(0.89e-4);
  EXPECT_EQ(better.verdict, Verdict::fail);
  EXPECT_EQ(better.reason, "better than the golden: propose a new one");
  EXPECT_EQ(judge_error(not_measured).verdict, Verdict::inconclusive);
}

TEST(Gate, AnUnstableOrFailedPointFailsAnErrorGolden) {
  for (const Status status : {Status::unstable, Status::failed}) {
    const GateResult result = judge(error_at_64, [&](StudyResult& s) {
      s.series[0].points[2].status = status;
      s.series[0].points[2].reason = "energy";
    });
    EXPECT_EQ(result.verdict, Verdict::fail);
    EXPECT_THAT(result.measured, HasSubstr("energy"));
    EXPECT_NE(result.reason, "");
  }
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

TEST(Gate, ANonMonotoneLimitIsInconclusiveUnlessItsBracketIsOutside) {
  StabilityLimit inside = bracket(0.798, 0.804);
  inside.monotone = false;
  EXPECT_EQ(judge_limit(inside).verdict, Verdict::inconclusive);
  StabilityLimit outside = bracket(0.5, 0.505);
  outside.monotone = false;
  EXPECT_EQ(judge_limit(outside).verdict, Verdict::fail);
}

TEST(Gate, ALimitThatWasNotFoundFailsOnlyWhenTheScanCoversTheBand) {
  StabilityLimit limit;
  EXPECT_EQ(judge_limit(limit).verdict, Verdict::inconclusive);
  limit.probes = {{0.1, true, ""}, {0.5, true, ""}};
  EXPECT_EQ(judge_limit(limit).verdict, Verdict::inconclusive);
  limit.probes = {{0.1, true, ""}, {1.5, true, ""}};
  const GateResult result = judge_limit(limit);
  EXPECT_EQ(result.verdict, Verdict::fail);
  EXPECT_EQ(result.measured, "all stable from 0.1 to 1.5");
  limit.probes[0].stable = false;
  limit.monotone = false;
  EXPECT_EQ(judge_limit(limit).verdict, Verdict::inconclusive);
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
}

TEST(Gate, AStatusMustBeTheExpectedOne) {
  const auto judge_status = [](Status expected, Status measured) {
    return judge({"s", "", StatusGolden{"a", 64, expected}},
                 [&](StudyResult& s) { s.series[0].points[2].status = measured; })
        .verdict;
  };
  EXPECT_EQ(judge_status(Status::unstable, Status::unstable), Verdict::pass);
  EXPECT_EQ(judge_status(Status::unstable, Status::ok), Verdict::fail);
  EXPECT_EQ(judge_status(Status::unstable, Status::failed), Verdict::fail);
  EXPECT_EQ(judge_status(Status::ok, Status::unstable), Verdict::fail);
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

TEST(Gate, OnlyTheNamedStudiesAreJudged) {
  const Golden other{"t", "t.toml:1", ValueGolden{.name = "x", .upper = 1}};
  const GateReport report = run_gate({order_two, other}, {healthy()}, {"s"});
  ASSERT_EQ(report.results.size(), 1U);
  EXPECT_EQ(report.results[0].study, "s");
  EXPECT_THROW(run_gate({order_two, other}, {healthy()}, {"s", "u"}), support::UsageError);
}

TEST(Gate, AGateThatChecksNothingIsAnError) {
  EXPECT_THROW(run_gate({}, {healthy()}), support::UsageError);
}

}  // namespace gate_test
}  // namespace mpmvv::goldens
