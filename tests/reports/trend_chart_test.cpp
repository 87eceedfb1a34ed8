#include "reports/trend_chart.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/plot_elements.hpp"
#include "reports/unstable_band.hpp"

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
  EXPECT_TRUE(holds(charts[1], errors[0].dots[2]));
  EXPECT_GT(errors[0].dots[2].drawn, top_of_values(charts[1]));
  EXPECT_EQ(errors.at(1).dots[2].mark, Mark::absent);
  EXPECT_NE(charts[1].caption.find("Crosses in the band at the upper edge: unstable."), std::string::npos);
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

TEST(TrendChart, OneNumberWithAnUnstableRunHasNoCourse) {
  const double none = support::not_measured;
  const History history{
      "", versions, {{"bars", Finding::Kind::order, "order of 'a'", {2, none}, none, {"unstable", ""}}}};
  EXPECT_TRUE(trend_charts("bars", history).empty()) << "the second version has not run it";
}

History two_versions(std::vector<claims::Trend> trends) {
  return {"", versions, std::move(trends)};
}

TEST(TrendChart, ErrorsOfDifferentQuantitiesHaveFiguresOfTheirOwnWithTheirUnits) {
  const auto charts = trend_charts(
      "bars",
      two_versions({{"bars", Finding::Kind::error, "error of 'a' in l2", {1, 2}, 32, {}, "l2"},
                    {"bars", Finding::Kind::order, "order of 'a' in l2", {1, 2}},
                    {"bars", Finding::Kind::error, "error of 'a' in stress_error", {300, 400}, 32, {}, "stress_error"},
                    {"bars", Finding::Kind::error, "error of 'b' in c' in l2", {3, 4}, 32, {}, "l2"}}));
  ASSERT_EQ(charts.size(), 3);
  EXPECT_EQ(charts[0].name, "bars-orders");
  EXPECT_EQ(charts[0].y.label, "observed order");
  EXPECT_EQ(charts[1].name, "bars-errors-l2");
  EXPECT_EQ(charts[1].y.label, "RMS displacement error (m)");
  EXPECT_EQ(charts[1].curves.size(), 2);
  EXPECT_LT(charts[1].y.to, 10) << "no place for stresses";
  EXPECT_EQ(charts[2].name, "bars-errors-stress_error");
  EXPECT_EQ(charts[2].y.label, "RMS stress error (Pa)");
  EXPECT_EQ(charts[2].caption, "Study bars: error of each series in stress_error at 32 in each version.");
}

TEST(TrendChart, ACaptionNamesTheQuantityWithoutItsUnit) {
  const auto charts =
      trend_charts("bars", two_versions({{"bars", Finding::Kind::error, "error of 'a' in l2", {1, 2}, 32, {}, "l2"},
                                         {"bars", Finding::Kind::error, "error of 'a' in l2", {1, 2}, 64, {}, "l2"}}));
  EXPECT_EQ(charts.at(0).caption, "Study bars: RMS displacement error in each version.");
}

TEST(TrendChart, LimitsOfDifferentKeysHaveFiguresOfTheirOwn) {
  const auto charts = trend_charts(
      "bars",
      two_versions({{"bars", Finding::Kind::limit, "cfl limit of 'a'", {0.7, 0.8}, support::not_measured, {}, "cfl"},
                    {"bars",
                     Finding::Kind::limit,
                     "smoothing_length limit of 'a'",
                     {0.1, 0.2},
                     support::not_measured,
                     {},
                     "smoothing_length"}}));
  ASSERT_EQ(charts.size(), 2);
  EXPECT_EQ(charts[0].y.label, "stability limit (CFL number)");
  EXPECT_EQ(charts[1].y.label, "stability limit (smoothing length / h)");
  EXPECT_NE(charts[0].name, charts[1].name);
}

TEST(TrendChart, NumbersThatAreNotPositiveAreDrawnToo) {
  const auto of_energy = [](double second) {
    return trend_charts(
               "bars",
               two_versions({{"bars", Finding::Kind::error, "error of 'a' in energy_loss", {1e-3, second}, 32}}))
        .at(0);
  };
  EXPECT_TRUE(of_energy(1e-2).y.log);
  const Chart gained = of_energy(-1e-2);
  EXPECT_FALSE(gained.y.log);
  EXPECT_EQ(gained.curves[0].dots[1].mark, Mark::inside);
  EXPECT_TRUE(gained.y.holds(-1e-2));
  EXPECT_THAT(gained.caption, testing::Not(testing::HasSubstr("Without a mark")));
}

TEST(TrendChart, VersionsOfACodeThatSayTheSameHaveTheirDigests) {
  EXPECT_EQ(names_of({{"0a1b2c3d4e", {"1.3"}, ""}, {"5f6a7b8c9d", {"1.3"}, ""}, {"aabbccddee", {"1.4"}, ""}}),
            (std::vector<std::string>{"0a1b2c3d4e", "5f6a7b8c9d", "1.4"}));
  EXPECT_EQ(names_of({{"0a1b2c3d4e", {"2026.11-beta-1"}, ""}, {"5f6a7b8c9d", {"2026.11-beta-2"}, ""}}),
            (std::vector<std::string>{"0a1b2c3d4e", "5f6a7b8c9d"}));
}

TEST(TrendChart, BuildsOfOneCommitAreToldFromEachOther) {
  const store::Version clean{"0a1b2c3d4e", {"c0ffee0123456789"}, ""},
      dirty{"5f6a7b8c9d", {"c0ffee0123456789-dirty"}, ""};
  EXPECT_EQ(names_of({clean, dirty}, ""), (std::vector<std::string>{"c0ffee012345", "c0ffee012345-dirty"}));
  EXPECT_EQ(names_of({dirty, {"aabbccddee112233", dirty.commits, ""}}, ""),
            (std::vector<std::string>{"5f6a7b8c9d", "aabbccddee11"}));
}

TEST(TrendChart, OfManyVersionsSomeAreNamedAndMarkedTheNewestAmongThem) {
  History history{"", {}, {{"bars", Finding::Kind::order, "order of 'a'", std::vector<double>(100, 2)}}};
  for (int v = 1; v <= 100; ++v) history.versions.push_back({fmt::format("d{}", v), {fmt::format("c{}", v)}, ""});
  const Chart chart = trend_charts("bars", history).at(0);
  ASSERT_EQ(chart.x.tics.size(), 7U);
  EXPECT_EQ(chart.x.tics.front().text, "c10");
  EXPECT_EQ(chart.x.tics.back().text, "c100");
  EXPECT_EQ(chart.curves[0].every, 4U);
  EXPECT_NE(chart.caption.find("One version in 4 has a mark."), std::string::npos);
  EXPECT_EQ(chart.curves[0].dots.size(), 100U);
  EXPECT_NE(plot_elements(chart, 1).find("data index 0 every 4::3 using 1:($4==1?$3:NaN) with points"),
            std::string::npos);
}

TEST(TrendChart, WhatWasMeasuredBesideGapsIsMarked) {
  History history{"", {}, {{"bars", Finding::Kind::order, "order of 'a'", std::vector<double>(30, 2)}}};
  for (int v = 1; v <= 30; ++v) history.versions.push_back({fmt::format("d{}", v), {fmt::format("c{}", v)}, ""});
  EXPECT_EQ(trend_charts("bars", history).at(0).curves[0].every, 2U);
  history.trends[0].remarks.assign(30, "");
  history.trends[0].remarks[4] = "failed";
  EXPECT_EQ(trend_charts("bars", history).at(0).curves[0].every, 1U) << "one that is hollow stands out";
  history.trends[0].remarks.clear();
  for (std::size_t v = 1; v < 30; v += 2) history.trends[0].numbers[v] = support::not_measured;
  EXPECT_EQ(trend_charts("bars", history).at(0).curves[0].every, 1U);
}

}  // namespace mpmvv::reports::trend_chart_test
