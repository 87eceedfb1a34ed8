#include "reports/axis_label.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "reports/text.hpp"
#include "studies/records/record.hpp"

namespace mpmvv::reports::axis_label_test {

TEST(AxisLabel, EveryErrorOfARunHasWordsOfItsOwnAndItsUnit) {
  std::set<std::string> labels;
  for (const std::string& quantity : records::norm_words()) {
    const std::string label = error_axis_label(quantity),
                      unit = replace_all(records::unit_of(quantity), "m/s2", "m/s²");
    EXPECT_THAT(label, testing::Not(testing::HasSubstr(quantity))) << "a word of stores";
    EXPECT_THAT(label, testing::HasSubstr(unit.empty() ? "" : "(" + unit));
    EXPECT_EQ(label.find('(') == std::string::npos, unit.empty()) << label;
    EXPECT_TRUE(labels.insert(label).second) << label;
  }
}

TEST(AxisLabel, WhatIsNotKnownStandsAsItIs) {
  EXPECT_EQ(error_axis_label("wall_seconds"), "wall_seconds (s)");
  EXPECT_EQ(error_axis_label(""), "error");
  EXPECT_EQ(limit_axis_label("cfl"), "CFL number");
  EXPECT_EQ(limit_axis_label("dt"), "dt");
}

}  // namespace mpmvv::reports::axis_label_test
