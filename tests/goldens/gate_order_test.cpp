#include <array>

#include "tests/goldens/healthy_study.hpp"

/// How the gate judges orders of convergence.
namespace mpmvv::goldens::gate_order_test {

using records::Point;
using support::not_measured;

using namespace healthy_study;

TEST(Gate, AnOrderIsThatOfItsWindowAndOfAllItsPoints) {
  const auto golden = [](std::vector<double> window, int points) {
    return Golden{"s", "s.toml:9", OrderGolden{"a", "l2", 2, 1.85, 2.15, std::move(window), points}};
  };
  const auto unchanged = [](StudyResult&) {};
  EXPECT_EQ(judge(golden({16, 64}, 3), unchanged).verdict, Verdict::pass);
  EXPECT_EQ(judge(golden({8, 64}, 3), unchanged).verdict, Verdict::inconclusive) << "another window";
  EXPECT_EQ(judge(golden({16, 64}, 4), unchanged).verdict, Verdict::fail) << "a point was lost";
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
  EXPECT_EQ(with(1.11e-3).reason, "the error at 64 is larger than 0.001 by more than 10 %, whatever the order");
}

/// Errors that have grown at all levels, and most at the coarse ones, look like a higher order.
TEST(Gate, AnErrorThatGrowsIsNotMadeGoodByAHigherOrder) {
  OrderGolden golden{"a", "l2", 1, 0.85, 1.15};
  golden.finest = {64, 1e-4};
  const auto with = [&](double error) {
    return judge(Golden{"s", "s.toml:9", golden}, [&](StudyResult& s) {
      s.series[0].orders[0].order = 1.277;
      s.series[0].points[2].y["l2"] = error;
    });
  };
  EXPECT_EQ(with(3.2e-4).verdict, Verdict::fail);
  EXPECT_FALSE(with(3.2e-4).better);
  EXPECT_EQ(with(3.2e-4).reason, "the error at 64 is larger than 0.0001 by more than 10 %, whatever the order");
  EXPECT_TRUE(with(1e-4).better);
}

/// The interval of a fit to three points of [16, 64].
TEST(Gate, AnOrderOfThreePointsReachesFromSegmentToSegment) {
  const auto with = [](double order, double first, double second) {
    return judge(order_two, [&](StudyResult& s) {
      s.series[0].orders[0].order = order;
      s.series[0].orders[0].segments = {{16, 32, first}, {32, 64, second}};
    });
  };
  EXPECT_EQ(with(2, 1.9, 2.1).verdict, Verdict::pass);
  EXPECT_EQ(with(2, 1.6, 2.4).reason, "its interval of ± 0.4 is too wide");
  EXPECT_EQ(with(1.75, 1.6, 1.9).reason, "outside the band, but its interval of ± 0.15 reaches in");
  EXPECT_EQ(with(1.6, 1.5, 1.7).reason, "order below the golden's band");
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
  EXPECT_EQ(judge_levels(golden({16, 64}, 3, {64, 1e-4}), unstable(3)).reason, "the run at 64 is unstable");
}

/// Where so many are lost that no order is left it must not be milder.
TEST(Gate, FailsHoweverManyPointsAreLost) {
  EXPECT_EQ(judge_order(2, 2).verdict, Verdict::fail);
  EXPECT_EQ(judge_order(not_measured, 1).verdict, Verdict::fail);
  EXPECT_EQ(judge_order(not_measured, 0).verdict, Verdict::fail);
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
                   s.series[0].orders[0].segments = {{16, 32, 2}, {32, 64, 2.5}};
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
  EXPECT_TRUE(limit("smoothing_length", 0.9, 0.905)) << "stable below, as its study file has it";
  EXPECT_FALSE(limit("cfl", 0.905, 0.9)) << "stable above";
}

TEST(Gate, OrdersWithoutEvidenceAreInconclusive) {
  EXPECT_EQ(judge_order(not_measured).verdict, Verdict::inconclusive);
  for (const double order : {2.0, 9.0}) {
    const GateResult of_two_points = judge(order_two, [order](StudyResult& s) {
      s.series[0].points.erase(s.series[0].points.begin() + 1);
      s.series[0].orders[0].points = 2;
      s.series[0].orders[0].order = order;
    });
    EXPECT_EQ(of_two_points.verdict, Verdict::inconclusive);
  }
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

}  // namespace mpmvv::goldens::gate_order_test
