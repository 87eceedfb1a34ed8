#include "reports/trend_chart.hpp"

#include <gtest/gtest.h>

namespace mpmvv::reports::trend_chart_test {

using claims::Finding;

const std::vector<store::Version> versions{{"d1", {"first"}, "2026-01-01"}, {"d2", {"second"}, "2026-01-02"}};

Chart orders_of(const std::vector<std::string>& names) {
  std::vector<claims::Trend> trends;
  for (const auto& name : names) trends.push_back({"bars", Finding::Kind::order, name, {1, 2}});
  return trend_charts("bars", trends, versions).at(0);
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

}  // namespace mpmvv::reports::trend_chart_test
