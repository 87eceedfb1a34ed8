#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "studies/fits/stability_limit.hpp"

/// The limit of several replicates, and what is said where there is none.
namespace mpmvv::fits::common_limit_test {

using ::testing::StartsWith;

StabilityLimit limit_of(const std::function<bool(double)>& is_stable, bool below) {
  const ProbeBatch probe = [&](const std::vector<double>& values) {
    std::vector<Probe> probes;
    for (const double value : values) probes.push_back({value, is_stable(value), ""});
    return probes;
  };
  return find_limit({.key = "cfl", .from = 0.1, .to = 2, .stable_below = below}, probe);
}

/// Of runs that are stable below a value, or from it on.
StabilityLimit limit_at(double value, bool below) {
  return limit_of([=](double v) { return (v < value) == below; }, below);
}

TEST(CommonLimit, ReachesFromWhereAllAreStableToWhereNoneIs) {
  for (const bool below : {true, false}) {
    const StabilityLimit low = limit_at(0.4, below), high = limit_at(0.6, below), middle = limit_at(0.5, below);
    const StabilityLimit common = common_limit({middle, low, high}, below);
    EXPECT_EQ(common.stable, below ? low.stable : high.stable);
    EXPECT_EQ(common.unstable, below ? high.unstable : low.unstable);
    EXPECT_TRUE(common.found);
    EXPECT_TRUE(common.monotone);
    EXPECT_EQ(common.probes.size(), low.probes.size() + high.probes.size() + middle.probes.size());
    EXPECT_TRUE(std::ranges::is_sorted(common.probes, {}, &Probe::value));
  }
  const StabilityLimit alone = limit_at(0.4, true), calm = limit_at(10, true);
  EXPECT_EQ(common_limit({alone}, true).stable, alone.stable);
  EXPECT_FALSE(common_limit({alone, calm}, true).found);
  EXPECT_TRUE(common_limit({alone, calm}, true).monotone) << "each of them is";
  const StabilityLimit island = limit_of([](double v) { return v < 0.4 || (v > 0.7 && v < 1); }, true);
  EXPECT_FALSE(common_limit({alone, island}, true).monotone);
  EXPECT_FALSE(common_limit({island, alone}, true).monotone);
}

TEST(CommonLimit, ThatReplicatesDoNotShareIsSaidWhicheverComesFirst) {
  for (const bool below : {true, false}) {
    const StabilityLimit calm = limit_at(below ? 10 : 0.01, below), wild = limit_at(below ? 0.01 : 10, below),
                         found = limit_at(1.05, below);
    for (const auto& both : std::vector<std::vector<StabilityLimit>>{
             {calm, found}, {found, calm}, {wild, found}, {found, wild}, {calm, wild}, {wild, calm}})
      EXPECT_EQ(text_without_limit(common_limit(both, below)), "replicates disagree");
    for (const auto& both : {common_limit({calm, found}, below), common_limit({found, calm}, below)}) {
      EXPECT_EQ(both.stable, found.stable);
      EXPECT_TRUE(std::isnan(both.unstable)) << "one of them is stable at all values";
    }
    for (const auto& both : {common_limit({wild, found}, below), common_limit({found, wild}, below)}) {
      EXPECT_TRUE(std::isnan(both.stable)) << "one of them is unstable at all values";
      EXPECT_EQ(both.unstable, found.unstable);
    }
    EXPECT_THAT(text_without_limit(common_limit({calm, calm}, below)), StartsWith("stable at all values tried"));
    EXPECT_THAT(text_without_limit(common_limit({wild, wild}, below)), StartsWith("unstable at all values tried"));
  }
}

TEST(TextWithoutLimit, SaysWhatIsKnown) {
  const auto text = [](double value, bool below) { return text_without_limit(limit_at(value, below)); };
  EXPECT_EQ(text(3, true), "stable at all values tried, up to 2");
  EXPECT_EQ(text(0.05, false), "stable at all values tried, down to 0.1");
  EXPECT_EQ(text(0.05, true), "unstable at all values tried, down to 0.1");
  EXPECT_EQ(text(3, false), "unstable at all values tried, up to 2");
  EXPECT_EQ(text_without_limit(limit_of([](double v) { return v > 0.5; }, true)),
            "stable at some of the values tried, unstable at others");
  EXPECT_EQ(text_without_limit({}), "nothing tried");
}

}  // namespace mpmvv::fits::common_limit_test
