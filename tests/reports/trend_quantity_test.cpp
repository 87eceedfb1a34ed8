#include "reports/trend_quantity.hpp"

#include <gtest/gtest.h>

#include <map>

namespace mpmvv::reports::trend_quantity_test {

using claims::Finding;
using claims::Trend;

TEST(TrendQuantity, IsThatOfTheFindingsName) {
  records::StudyResult study;
  study.name = "s", study.sweep = "cells";
  records::Series series{"b' in c of 'd", {{8, records::Status::ok, "", {{"stress_error", 2}}}}, {}, {}};
  series.orders.resize(1);
  series.orders[0].norm = "stress_error", series.orders[0].order = 1;
  series.extrapolations.resize(1);
  series.extrapolations[0].norm = "l2", series.extrapolations[0].limit = 1;
  series.limit.emplace();
  series.limit->key = "cfl";
  study.series = {series};
  study.values = {{"gap", 1, ""}};
  std::map<std::string, std::string> quantities;
  for (const Trend& trend : claims::trends_of({claims::findings_of(study)}))
    quantities[label_with_unit(trend)] = quantity_of(trend);
  const std::map<std::string, std::string> expected{
      {"order of 'b' in c of 'd' in stress_error over [0, 0]", ""},
      {"error of 'b' in c of 'd' in stress_error (Pa) at 8", "stress_error"},
      {"extrapolated l2 (m) of 'b' in c of 'd' over [0, 0]", "l2"},
      {"cfl limit of 'b' in c of 'd'", "cfl"},
      {"value 'gap'", ""}};
  EXPECT_EQ(quantities, expected);
}

TEST(TrendQuantity, ANameWithoutOneHasNone) {
  for (const auto kind : {Finding::Kind::error, Finding::Kind::limit, Finding::Kind::value}) {
    const Trend trend{"s", kind, "of 'a'", {1}};
    EXPECT_EQ(quantity_of(trend), "");
    EXPECT_EQ(label_with_unit(trend), "of 'a'");
  }
}

}  // namespace mpmvv::reports::trend_quantity_test
