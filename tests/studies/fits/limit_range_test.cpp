#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "studies/fits/stability_limit.hpp"
#include "tests/numbers.hpp"

/// Where a limit may lie, also where one end alone is known.
namespace mpmvv::fits::limit_range_test {

StabilityLimit limit_of(const std::function<bool(double)>& is_stable, bool stable_below) {
  return find_limit({.key = "cfl", .from = 0.1, .to = 2, .stable_below = stable_below},
                    [&](const std::vector<double>& values) {
                      std::vector<Probe> probes;
                      for (const double v : values) probes.push_back({v, is_stable(v), ""});
                      return probes;
                    });
}

void expect_range(const StabilityLimit& limit, double lower, double upper, bool stable_below) {
  const auto range = range_of(limit);
  ASSERT_TRUE(range.has_value());
  EXPECT_EQ(range->lower, lower);
  EXPECT_EQ(range->upper, upper);
  EXPECT_EQ(range->stable_below, stable_below);
  EXPECT_EQ(range->is_open(), lower == 0 || std::isinf(upper));
}

TEST(LimitRange, ReachesToWhatWasTried) {
  const auto always = [](double) { return true; };
  const auto never = [](double) { return false; };
  expect_range(limit_of(always, true), 2, infinity, true);
  expect_range(limit_of(always, false), 0, 0.1, false);
  expect_range(limit_of(never, true), 0, 0.1, true);
  expect_range(limit_of(never, false), 2, infinity, false);
  const StabilityLimit up = limit_of([](double v) { return v < 0.5; }, true),
                       down = limit_of([](double v) { return v > 0.5; }, false);
  expect_range(up, up.stable, up.unstable, true);
  expect_range(down, down.unstable, down.stable, false);
  EXPECT_FALSE(range_of(limit_of([](double v) { return v > 0.5; }, true))) << "both ends contradict the search";
  EXPECT_FALSE(range_of({.key = "x", .stable = 1, .probes = {{1, true, ""}}})) << "one value, of which side?";
  EXPECT_FALSE(range_of({}));
  const StabilityLimit far_end_stable = limit_of([](double v) { return v < 0.5 || v > 1.9; }, true);
  expect_range(far_end_stable, far_end_stable.stable, infinity, true);
}

TEST(LimitRange, OfReplicatesThatDisagreeHasOneEnd) {
  for (const bool below : {true, false}) {
    const auto at = [=](double limit) { return limit_of([=](double v) { return (v < limit) == below; }, below); };
    const StabilityLimit calm = at(below ? 3 : 0.01), wild = at(below ? 0.01 : 3), found = at(0.5);
    for (const auto& both : {common_limit({calm, found}, below), common_limit({found, calm}, below)})
      expect_range(both, below ? found.stable : 0, below ? infinity : found.stable, below);
    for (const auto& both : {common_limit({wild, found}, below), common_limit({found, wild}, below)})
      expect_range(both, below ? 0 : found.unstable, below ? found.unstable : infinity, below);
    EXPECT_FALSE(range_of(common_limit({calm, wild}, below)));
  }
}

TEST(LimitRange, OfReplicatesOfWhichNoneIsFoundHasTheirSide) {
  // Stable down to 1 and 1.5, and at the low end again.
  const auto down_to = [](double limit) { return limit_of([=](double v) { return v > limit || v < 0.11; }, false); };
  const StabilityLimit a = down_to(1), b = down_to(1.5);
  for (const auto& both : {common_limit({a, b}, false), common_limit({b, a}, false)})
    expect_range(both, 0, b.stable, false);
}

TEST(LimitRange, IsSureOnTheSideOfStableRunsByThoseWithEnoughSteps) {
  const auto sure = [](const StabilityLimit& limit) { return *sure_range_of(limit); };
  const StabilityLimit below{.key = "cfl",
                             .stable = 0.5,
                             .unstable = 0.6,
                             .found = true,
                             .probes = {{0.3, true, "", 60},
                                        {0.4, true, "", 40},
                                        {0.5, true, "", 39},
                                        {0.6, false, "energy", 5},
                                        {0.7, true, "", 90}}};
  EXPECT_EQ(sure(below).lower, 0.4);
  EXPECT_EQ(sure(below).upper, 0.6);
  const StabilityLimit above{.key = "smoothing_length",
                             .stable = 0.5,
                             .unstable = 0.4,
                             .found = true,
                             .probes = {{0.4, false, "energy", 5}, {0.5, true, "", 39}, {0.6, true, "", 40}}};
  EXPECT_EQ(sure(above).lower, 0.4);
  EXPECT_EQ(sure(above).upper, 0.6);
  const StabilityLimit old{.key = "cfl", .stable = 2, .probes = {{1, true, ""}, {2, true, ""}}};
  EXPECT_EQ(sure(old).lower, 2) << "stores of older versions do not know the steps";
  const StabilityLimit mixed{
      .key = "cfl", .stable = 3, .probes = {{1, true, "", 60}, {2, true, ""}, {3, true, "", 5}, {4, false, "", 3}}};
  EXPECT_EQ(sure(mixed).lower, 2) << "unknown steps count as enough";
  EXPECT_FALSE(sure_range_of({.key = "cfl", .stable = 2, .probes = {{1, true, "", 9}, {2, true, "", 5}}}));
}

TEST(StepsAtLimit, AreThoseOfTheLastStableRun) {
  const StabilityLimit limit{.key = "cfl",
                             .stable = 0.5,
                             .unstable = 0.6,
                             .probes = {{0.4, true, "", 50}, {0.5, true, "", 40}, {0.6, false, "energy", 32}}};
  EXPECT_EQ(steps_at_limit(limit), 40);
  EXPECT_EQ(steps_at_limit({.key = "cfl", .unstable = 0.6, .probes = {{0.6, false, "energy", 32}}}), 0)
      << "nothing is stable";
}

TEST(StepsAtLimit, MakeRoundOffGrowToAllOfIt) {
  EXPECT_NEAR(1e-12 * std::pow(least_visible_growth(185), 185), 1, 1e-9);
  EXPECT_TRUE(std::isnan(least_visible_growth(0)));
}

}  // namespace mpmvv::fits::limit_range_test
