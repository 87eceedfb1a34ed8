#include "studies/fits/stability_limit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

#include "studies/support/error.hpp"
#include "tests/numbers.hpp"

namespace mpmvv::fits::stability_limit_test {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Counts what the search asks for.
struct Prober {
  std::function<bool(double)> stable;
  std::vector<std::size_t> batches = {};
  std::vector<double> asked = {};
  std::function<double(double)> run = [](double v) { return v; };  ///< what becomes of a value asked for

  ProbeBatch batch() {
    return [this](const std::vector<double>& values) {
      batches.push_back(values.size());
      std::vector<Probe> probes;
      for (const double v : values) {
        asked.push_back(v);
        probes.push_back({run(v), stable(run(v)), stable(run(v)) ? "" : "energy grew"});
      }
      return probes;
    };
  }
};

LimitSearch cfl_search() {
  return {.key = "cfl", .from = 0.1, .to = 2};
}

TEST(StabilityLimit, BracketsAKnownLimitWithinTheTolerance) {
  for (const double limit : {0.1001, 0.3, 0.577, 1.0, std::sqrt(2.0), 1.9999})
    for (const double tolerance : {0.3, 0.01, 1e-6})
      for (const bool below : {true, false}) {
        LimitSearch search = cfl_search();
        search.tolerance = tolerance;
        search.stable_below = below;
        Prober prober{[=](double v) { return below ? v <= limit : v >= limit; }};
        const StabilityLimit found = find_limit(search, prober.batch());
        ASSERT_TRUE(found.found);
        EXPECT_TRUE(found.monotone);
        EXPECT_EQ(found.key, "cfl");
        EXPECT_LE(std::min(found.stable, found.unstable), limit);
        EXPECT_GE(std::max(found.stable, found.unstable), limit);
        EXPECT_EQ(found.stable < found.unstable, below);
        EXPECT_LE(std::abs(found.unstable - found.stable), tolerance * found.stable);
      }
}

TEST(StabilityLimit, LimitOnAScanPointIsBracketed) {
  for (const double limit : {1.0, 2.0, 4.0})
    for (const bool below : {true, false}) {
      const LimitSearch search{.key = "x", .from = 0.5, .to = 8, .scan_ratio = 2, .stable_below = below};
      Prober prober{[=](double v) { return below ? v <= limit : v >= limit; }};
      const StabilityLimit found = find_limit(search, prober.batch());
      EXPECT_EQ(found.stable, limit);
      EXPECT_NEAR(found.unstable, limit, 0.01 * limit);
    }
}

TEST(StabilityLimit, ScanIsOneGeometricBatchWithBothEnds) {
  Prober prober{[](double v) { return v < 0.7; }};
  find_limit(cfl_search(), prober.batch());
  const std::size_t scanned = prober.batches.front();
  EXPECT_EQ(scanned, 33u);  // log 20 / log 1.1 = 31.4
  EXPECT_EQ(prober.asked.front(), 0.1);
  EXPECT_EQ(prober.asked[scanned - 1], 2);
  const double ratio = prober.asked[1] / prober.asked[0];
  EXPECT_LE(ratio, 1.1);
  for (std::size_t k = 1; k < scanned; ++k) EXPECT_NEAR(prober.asked[k] / prober.asked[k - 1], ratio, 1e-12);
}

TEST(StabilityLimit, AWholeNumberOfStepsGetsNoExtraOne) {
  Prober prober{[](double v) { return v < 5; }};
  find_limit({.key = "x", .from = 1, .to = 125, .scan_ratio = 5}, prober.batch());  // log 125 / log 5 > 3 in doubles
  EXPECT_EQ(prober.batches.front(), 4u);
}

TEST(StabilityLimit, ARangeShorterThanTheRatioIsTwoProbes) {
  Prober prober{[](double v) { return v < 1.05; }};
  const StabilityLimit found = find_limit({.key = "x", .from = 1, .to = 1.1, .scan_ratio = 2}, prober.batch());
  EXPECT_EQ(prober.batches.front(), 2u);
  EXPECT_TRUE(found.found);
}

TEST(StabilityLimit, NumberOfProbesIsBounded) {
  for (const double tolerance : {0.05, 0.01, 1e-9}) {
    LimitSearch search = cfl_search();
    search.tolerance = tolerance;
    Prober prober{[](double v) { return v < 0.7; }};
    find_limit(search, prober.batch());
    constexpr double around = 6;
    const double halvings = std::ceil(std::log2(std::log(1.1) / std::log1p(tolerance))) + 1;
    EXPECT_LE(static_cast<double>(prober.asked.size()), 33 + halvings + around);
  }
}

/// A step that divides the end time: v becomes 8/n, n whole, as a CFL number does.
Prober stepwise(const std::function<bool(double)>& stable) {
  return {stable, {}, {}, [](double v) { return 8 / std::ceil(8 / v); }};
}

TEST(StabilityLimit, BracketsWhatWasRun) {
  Prober prober = stepwise([](double v) { return v < 0.7; });
  const StabilityLimit found = find_limit(cfl_search(), prober.batch());
  ASSERT_TRUE(found.found);
  EXPECT_EQ(found.stable, 8.0 / 12);
  EXPECT_EQ(found.unstable, 8.0 / 11) << "wider than the tolerance, but no run lies between";
  for (std::size_t k = 1; k < found.probes.size(); ++k)
    EXPECT_LT(found.probes[k - 1].value, found.probes[k].value) << "each run once";
  EXPECT_EQ(found.probes.back().value, 2) << "8/4, and not what was asked for";
}

TEST(StabilityLimit, BracketsWhatWasRunDownToTheTolerance) {
  Prober prober = stepwise([](double v) { return v < 0.1303; });  // 8/61 = 0.1311, 8/62 = 0.1290
  LimitSearch search = cfl_search();
  search.scan_ratio = 2;
  const StabilityLimit found = find_limit(search, prober.batch());
  EXPECT_EQ(found.stable, 8.0 / 62);
  EXPECT_EQ(found.unstable, 8.0 / 61);
}

TEST(StabilityLimit, OneRunForTheWholeRangeHasNoLimit) {
  for (const bool calm : {true, false}) {
    Prober prober = stepwise([=](double) { return calm; });
    const StabilityLimit found = find_limit({.key = "cfl", .from = 8, .to = 15}, prober.batch());
    EXPECT_FALSE(found.found);
    EXPECT_EQ(found.probes.size(), 1u);
    EXPECT_EQ(calm ? found.stable : found.unstable, 8);
  }
}

TEST(StabilityLimit, EveryProbeIsKeptInIncreasingValueWithItsReason) {
  for (const bool below : {true, false}) {
    LimitSearch search = cfl_search();
    search.stable_below = below;
    Prober prober{[=](double v) { return (v < 0.7) == below; }};
    const StabilityLimit found = find_limit(search, prober.batch());
    std::sort(prober.asked.begin(), prober.asked.end());
    ASSERT_EQ(found.probes.size(), prober.asked.size());
    for (std::size_t k = 0; k < found.probes.size(); ++k) {
      const Probe& p = found.probes[k];
      EXPECT_EQ(p.value, prober.asked[k]);
      EXPECT_EQ(p.stable, (p.value < 0.7) == below);
      EXPECT_EQ(p.reason, p.stable ? "" : "energy grew");
    }
  }
}

TEST(StabilityLimit, WhereStabilityIsNotMonotoneTheBracketReachesOverAllIslands) {
  const auto island = [](double v) { return v < 0.5 || (v > 1 && v < 1.5); };  // stable below 0.5, and again from 1
  Prober up{island};
  const StabilityLimit below = find_limit(cfl_search(), up.batch());
  EXPECT_TRUE(below.found);
  EXPECT_FALSE(below.monotone);
  EXPECT_NEAR(below.stable, 0.5, 0.005);
  EXPECT_GE(below.unstable, 1.5);
  EXPECT_LT(below.unstable, 1.5 * 1.01);

  LimitSearch search = cfl_search();
  search.stable_below = false;
  Prober down{[&](double v) { return !island(v); }};
  const StabilityLimit above = find_limit(search, down.batch());
  EXPECT_TRUE(above.found);
  EXPECT_FALSE(above.monotone);
  EXPECT_NEAR(above.stable, 1.5, 0.015);
  EXPECT_NEAR(above.unstable, 0.5, 0.005);
}

TEST(StabilityLimit, IslandsNearTheBracketThatTheScanMissesAreFound) {
  for (const bool below : {true, false}) {
    // On the stable side of 1 an unstable island from 2.5 to 1.5 %, on the other side a stable one around 3 %.
    const auto is_stable = [=](double v) {
      const double way = below ? v - 1 : 1 - v;
      return way < -0.025 || (way > -0.015 && way < 0) || (way > 0.025 && way < 0.035);
    };
    const LimitSearch search{.key = "x", .from = 0.1, .to = 10, .scan_ratio = 10, .stable_below = below};
    Prober prober{is_stable};
    const StabilityLimit found = find_limit(search, prober.batch());
    EXPECT_FALSE(found.monotone);
    EXPECT_NEAR(found.stable, below ? 0.975 : 1.025, 0.011);
    EXPECT_NEAR(found.unstable, below ? 1.04 : 0.96, 0.01);
    for (const Probe& p : found.probes) {
      if (below ? p.value <= found.stable : p.value >= found.stable) {
        EXPECT_TRUE(p.stable) << p.value;
      }
      if (below ? p.value >= found.unstable : p.value <= found.unstable) {
        EXPECT_FALSE(p.stable) << p.value;
      }
    }
  }
}

TEST(StabilityLimit, NothingIsProbedTwiceOrOutsideOfTheRange) {
  for (const double limit : {0.101, 0.5, 1.99})
    for (const bool below : {true, false}) {
      LimitSearch search = cfl_search();
      search.stable_below = below;
      Prober prober{[=](double v) { return (v < limit) == below; }};
      find_limit(search, prober.batch());
      EXPECT_EQ(std::set(prober.asked.begin(), prober.asked.end()).size(), prober.asked.size());
      EXPECT_EQ(*std::ranges::min_element(prober.asked), search.from);
      EXPECT_EQ(*std::ranges::max_element(prober.asked), search.to);
    }
}

TEST(StabilityLimit, AllStableOrAllUnstableIsNotFound) {
  for (const bool below : {true, false}) {
    LimitSearch search = cfl_search();
    search.stable_below = below;
    Prober calm{[](double) { return true; }}, wild{[](double) { return false; }};

    const StabilityLimit stable = find_limit(search, calm.batch());
    EXPECT_FALSE(stable.found);
    EXPECT_TRUE(stable.monotone);
    EXPECT_EQ(stable.stable, below ? 2 : 0.1);
    EXPECT_TRUE(std::isnan(stable.unstable));
    EXPECT_TRUE(std::isnan(stable.value()));
    EXPECT_EQ(stable.probes.size(), 33u);

    const StabilityLimit unstable = find_limit(search, wild.batch());
    EXPECT_FALSE(unstable.found);
    EXPECT_TRUE(unstable.monotone);
    EXPECT_EQ(unstable.unstable, below ? 0.1 : 2);
    EXPECT_TRUE(std::isnan(unstable.stable));
  }
}

TEST(StabilityLimit, AnUnstableStableEndIsNotFoundAndNotMonotone) {
  Prober prober{[](double v) { return v > 0.5; }};
  const StabilityLimit found = find_limit(cfl_search(), prober.batch());
  EXPECT_FALSE(found.found);
  EXPECT_FALSE(found.monotone);
  EXPECT_TRUE(std::isnan(found.stable));
  EXPECT_TRUE(std::isnan(found.unstable)) << "the far end is stable";
  EXPECT_EQ(prober.batches.size(), 1u);
}

TEST(StabilityLimit, IsDeterministic) {
  Prober a{[](double v) { return v < 0.123; }}, b{a.stable};
  const StabilityLimit first = find_limit(cfl_search(), a.batch()), second = find_limit(cfl_search(), b.batch());
  EXPECT_EQ(a.asked, b.asked);
  EXPECT_EQ(first.stable, second.stable);
  EXPECT_EQ(first.unstable, second.unstable);
}

TEST(StabilityLimit, BadSearchesAreRejectedBeforeAnyProbe) {
  const auto rejects = [](LimitSearch search, const std::string& why) {
    Prober prober{[](double) { return true; }};
    EXPECT_THAT([&] { find_limit(search, prober.batch()); }, ThrowsMessage<support::UsageError>(HasSubstr(why)));
    EXPECT_TRUE(prober.asked.empty());
  };
  for (const double bad : {0.0, -1.0, nan, infinity}) rejects({.key = "cfl", .from = bad, .to = 2}, "'cfl': from =");
  for (const double bad : {0.1, 0.05, -1.0, nan, infinity}) rejects({.key = "cfl", .from = 0.1, .to = bad}, "to =");
  for (const double bad : {1.0, 0.5, 0.0, -2.0, nan, infinity})
    rejects({.key = "cfl", .from = 0.1, .to = 2, .scan_ratio = bad}, "scan_ratio =");
  for (const double bad : {0.0, -0.1, 1.0, 1e-16, nan, infinity})
    rejects({.key = "cfl", .from = 0.1, .to = 2, .tolerance = bad}, "tolerance =");
  rejects({.key = "cfl", .from = 0.1, .to = 2, .scan_ratio = 1 + 1e-15}, "more than 1000 steps");
}

TEST(StabilityLimit, AMissingVerdictIsABugOfTheCaller) {
  const ProbeBatch forgetful = [](const std::vector<double>&) { return std::vector<Probe>(1); };
  EXPECT_THROW(find_limit(cfl_search(), forgetful), std::logic_error);
}

}  // namespace mpmvv::fits::stability_limit_test
