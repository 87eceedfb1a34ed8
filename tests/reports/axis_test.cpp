#include "reports/axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace mpmvv::reports::axis_test {

std::vector<std::string> texts(const Axis& axis) {
  std::vector<std::string> result;
  for (const auto& tic : axis.tics)
    if (!tic.text.empty()) result.push_back(tic.text);
  return result;
}

TEST(Axis, HoldsAllValuesWithItsMargins) {
  const std::vector<double> values{1e-6, 3e-2, NAN, 0, -1};
  const Axis axis = make_axis({"e", true, {}, {}, 0.1, 0.2, false}, values);
  EXPECT_NEAR(axis.fraction(1e-6), 0.1 / 1.3, 1e-12);
  EXPECT_NEAR(axis.fraction(3e-2), 1.1 / 1.3, 1e-12);
  EXPECT_NEAR(axis.value(axis.fraction(1e-4)), 1e-4, 1e-16);
}

TEST(Axis, NamesDecadesByPowers) {
  const Axis axis = make_axis({"e", true, 1e-5, 1e-1, 0, 0, false}, {});
  EXPECT_EQ(texts(axis), (std::vector<std::string>{"10^-5", "10^-4", "10^-3", "10^-2", "10^-1"}));
}

TEST(Axis, PutsTicsAtFewValues) {
  const std::vector<double> cells{8, 16, 32, 64, 8};
  EXPECT_EQ(texts(make_axis({"N", true, {}, {}, 0.1, 0.1, true}, cells)),
            (std::vector<std::string>{"8", "16", "32", "64"}));
}

TEST(Axis, DoesNotPutTicsAtCrowdedValues) {
  const std::vector<double> crowded{1, 1.01, 100};
  EXPECT_EQ(texts(make_axis({"x", true, {}, {}, 0, 0, true}, crowded)), (std::vector<std::string>{"1", "10", "100"}));
}

TEST(Axis, ShortLogarithmicAxisStillHasTics) {
  const std::vector<double> values{0.953, 1.042};
  EXPECT_GE(texts(make_axis({"x", true, {}, {}, 0, 0, false}, values)).size(), 3u);
}

TEST(Axis, LinearTicsAreRound) {
  const std::vector<double> values{-1, 1};
  EXPECT_EQ(texts(make_axis({"x", false, {}, {}, 0, 0, false}, values)),
            (std::vector<std::string>{"-1", "-0.5", "0", "0.5", "1"}));
}

TEST(Axis, WritesManyCellsOut) {
  const std::vector<double> cells{8192, 16384, 32768};
  EXPECT_EQ(texts(make_axis({"N", true, {}, {}, 0.1, 0.1, true}, cells)),
            (std::vector<std::string>{"8192", "16384", "32768"}));
}

/// As of an order that changes in its sixth digit from version to version.
TEST(Axis, TicsThatLieCloseAreToldApart) {
  const std::vector<double> near_two{2.0000115, 2.0000245}, near_a_fifth{0.20002, 0.20024}, large{123456.3, 123457.6};
  EXPECT_EQ(
      texts(make_axis({"order", false, {}, {}, 0, 0}, near_two)),
      (std::vector<std::string>{"2.000012", "2.000014", "2.000016", "2.000018", "2.00002", "2.000022", "2.000024"}));
  EXPECT_EQ(texts(make_axis({"error", false, {}, {}, 0, 0}, near_a_fifth)),
            (std::vector<std::string>{"0.20005", "0.2001", "0.20015", "0.2002"}));
  EXPECT_EQ(texts(make_axis({"energy", false, {}, {}, 0, 0}, large)),
            (std::vector<std::string>{"1.234564·10^5", "1.234566·10^5", "1.234568·10^5", "1.23457·10^5",
                                      "1.234572·10^5", "1.234574·10^5", "1.234576·10^5"}));
}

TEST(Axis, OneValueAndNoValueGiveAnInterval) {
  const std::vector<double> one{0.25};
  const Axis axis = make_axis({"x", false, {}, {}, 0, 0, false}, one);
  EXPECT_LT(axis.from, 0.25);
  EXPECT_GT(axis.to, 0.25);
  const Axis empty = make_axis({"x", true, {}, {}, 0, 0, false}, {});
  EXPECT_LT(empty.from, empty.to);
}

TEST(Axis, NonPositiveEndOfALogarithmicAxisIsIgnored) {
  const std::vector<double> values{1, 10};
  EXPECT_GT(make_axis({"x", true, 0.0, {}, 0, 0, false}, values).from, 0);
}

TEST(Axis, RangesThatTicsCannotStepThroughAreWidened) {
  const double tiny = 5e-324, huge = std::numeric_limits<double>::max();
  for (const double from : {0.0, tiny, 1e-300, 1e-20, 1.0, 3e15, 1e300, huge, -1.0, -huge})
    for (const double to : {std::nextafter(from, INFINITY), std::nextafter(from * (1 + 3e-16), INFINITY), huge})
      for (const bool log : {false, true}) {
        const std::vector<double> values{from, to};
        for (const AxisWish& wish : {AxisWish{"x", log, from, to}, AxisWish{"x", log, {}, {}, 0.1, 0.1, true}}) {
          const Axis axis = make_axis(wish, values);
          EXPECT_TRUE(std::isfinite(axis.from) && std::isfinite(axis.to)) << from << " to " << to;
          EXPECT_GT(axis.to, axis.from) << from << " to " << to;
          EXPECT_FALSE(axis.tics.empty()) << from << " to " << to;
          EXPECT_LT(axis.tics.size(), 700u) << from << " to " << to;
          for (std::size_t k = 1; k < axis.tics.size(); ++k)
            ASSERT_GT(axis.tics[k].at, axis.tics[k - 1].at)
                << from << " to " << to << (log ? " log" : "") << wish.tics_at_values;
        }
      }
}

}  // namespace mpmvv::reports::axis_test
