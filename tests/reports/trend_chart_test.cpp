#include "reports/trend_chart.hpp"

#include <gtest/gtest.h>

namespace mpmvv::reports::trend_chart_test {

using claims::Finding;

const std::vector<store::Version> versions{{"d1", {"first"}, "2026-01-01"}, {"d2", {"second"}, "2026-01-02"}};

Chart orders_of(const std::vector<std::string>& names) {
  History history{"", versions, {}};
  for (const auto& name : names) history.trends.push_back({"bars", Finding::Kind::order, name, {1, 2}});
  return trend_charts("bars", history).at(0);
}

/// What stands below the axis of the versions of a code, or of our own program.
std::vector<std::string> names_of(const std::vector<store::Version>& of_code, const std::string& code = "my-code") {
  const std::vector<double> orders(of_code.size(), 2);
  const History history{code, of_code, {{"bars", Finding::Kind::order, "order of 'a'", orders}}};
  std::vector<std::string> names;
  const Chart chart = trend_charts("bars", history).at(0);
  for (const auto& tic : chart.x.tics) names.push_back(tic.text);
  return names;
}

TEST(TrendChart, KeysAreTheSeriesWhereTheRestIsTheSame) {
  const Chart chart = orders_of({"order of 'hats' in l2 over [8, 64]", "order of 'it's' in l2 over [8, 64]"});
  EXPECT_EQ(chart.curves[0].key, "hats");
  EXPECT_EQ(chart.curves[1].key, "it's");
  EXPECT_EQ(chart.caption, "Study bars: order of each series in l2 over [8, 64] in each version.");
}

TEST(TrendChart, KeysSayAllWhereTheRestDiffers) {
  const Chart chart = orders_of({"order of 'hats' in l2 over [8, 64]", "order of 'hats' in linf over [8, 64]"});
  EXPECT_EQ(chart.curves[1].key, "order of 'hats' in linf over [8, 64]");
  EXPECT_EQ(chart.caption, "Study bars: observed order in each version.");
}

TEST(TrendChart, ANumberWithoutAllOfItsRunsIsHollowAndAnUnstableRunACross) {
  const double none = support::not_measured;
  History history{
      "", versions, {{"bars", Finding::Kind::order, "order of 'a'", {2, 2, 2}, none, {"", "unstable", ""}}}};
  history.versions.push_back({"d3", {"third"}, "2026-01-03"});
  for (const char* remark : {"unstable", "failed"})
    history.trends.push_back(
        {"bars", Finding::Kind::error, std::string("of ") + remark, {1, 2, none}, 32, {"", "", remark}});
  const auto charts = trend_charts("bars", history);
  const auto& orders = charts.at(0).curves.at(0).dots;
  EXPECT_EQ(orders[0].mark, Mark::inside);
  EXPECT_EQ(orders[1].mark, Mark::outside);
  EXPECT_NE(charts[0].caption.find("Hollow: a run of the window is unstable or failed."), std::string::npos);
  const auto& errors = charts.at(1).curves;
  EXPECT_EQ(errors.at(0).dots[2].mark, Mark::unstable);
  EXPECT_TRUE(charts[1].y.holds(errors[0].dots[2].drawn));
  EXPECT_EQ(errors.at(1).dots[2].mark, Mark::absent);
  EXPECT_NE(charts[1].caption.find("Crosses at the upper edge: unstable."), std::string::npos);
}

TEST(TrendChart, ALevelThatHasJustBecomeUnstableIsDrawn) {
  const double none = support::not_measured;
  const History history{"",
                        versions,
                        {{"bars", Finding::Kind::error, "of 'a'", {1, none}, 32, {"", "unstable"}},
                         {"bars", Finding::Kind::error, "of 'b'", {1, none}, 32, {"", ""}},
                         {"bars", Finding::Kind::error, "of 'c'", {none, none}, 32, {"unstable", "unstable"}}}};
  const auto charts = trend_charts("bars", history);
  ASSERT_EQ(charts.size(), 1);
  ASSERT_EQ(charts[0].curves.size(), 1);
  EXPECT_EQ(charts[0].curves[0].dots[1].mark, Mark::unstable);
}

TEST(TrendChart, VersionsOfACodeThatSayTheSameHaveTheirDigests) {
  EXPECT_EQ(names_of({{"0a1b2c3d4e", {"1.3"}, ""}, {"5f6a7b8c9d", {"1.3"}, ""}, {"aabbccddee", {"1.4"}, ""}}),
            (std::vector<std::string>{"0a1b2c3", "5f6a7b8", "1.4"}));
  EXPECT_EQ(names_of({{"0a1b2c3d4e", {"2026.11-beta-1"}, ""}, {"5f6a7b8c9d", {"2026.11-beta-2"}, ""}}),
            (std::vector<std::string>{"0a1b2c3", "5f6a7b8"}));
}

TEST(TrendChart, BuildsOfOneCommitAreToldFromEachOther) {
  const store::Version clean{"0a1b2c3d4e", {"c0ffee0123456789"}, ""},
      dirty{"5f6a7b8c9d", {"c0ffee0123456789-dirty"}, ""};
  EXPECT_EQ(names_of({clean, dirty}, ""), (std::vector<std::string>{"c0ffee0", "c0ffee0-dirty"}));
  EXPECT_EQ(names_of({dirty, {"aabbccddee", dirty.commits, ""}}, ""), (std::vector<std::string>{"5f6a7b8", "aabbccd"}));
}

}  // namespace mpmvv::reports::trend_chart_test
