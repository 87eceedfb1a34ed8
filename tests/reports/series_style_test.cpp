#include "reports/series_style.hpp"

#include <gtest/gtest.h>

#include "reports/chart.hpp"
#include "tests/reports/rules.hpp"
#include "tests/reports/synthetic.hpp"

/// The look of a series in the figures of its study.
namespace mpmvv::reports::series_style_test {

TEST(SeriesStyle, ASeriesHasOneStyleInAllFiguresOfItsStudy) {
  auto study = synthetic::convergence();
  const auto all = error_chart(study, study.figures[0]);
  study.figures.push_back(study.figures[0]);
  study.figures[1].name = "some", study.figures[1].series = {study.series[3].name, study.series[1].name};
  const auto some = error_chart(study, study.figures[1]);
  EXPECT_EQ(some.curves[0].style, all.curves[3].style);
  EXPECT_EQ(some.curves[1].style, all.curves[1].style);
  const auto fits = rules(some, Rule::Kind::fit);
  ASSERT_EQ(fits.size(), 2u);
  EXPECT_EQ(fits[0].style, all.curves[3].style);
  EXPECT_EQ(fits[1].style, all.curves[1].style);
}

/// Figures of other series each begin with the first style; one series between them keeps its own.
TEST(SeriesStyle, FiguresWithoutACommonSeriesBeginAnew) {
  records::StudyResult study;
  for (const char* name : {"a", "b", "c", "d", "e"}) study.series.push_back({name, {}, {}, {}});
  records::Figure first, second;
  first.series = {"b", "a"}, second.series = {"d", "c", "e", "b"};
  study.figures = {first, second};
  const std::map<std::string, int> expected{{"a", 0}, {"b", 1}, {"c", 0}, {"d", 2}, {"e", 3}};
  EXPECT_EQ(series_styles(study), expected);
}

TEST(SeriesStyle, WhatAPaperNamesHasOneStyleInAllOfItsStudies) {
  records::StudyResult study;
  study.name = "w-fig7";
  for (const char* name : {"USL-cpGIMP", "another", "CD-cpGIMP"}) study.series.push_back({name, {}, {}, {}});
  study.figures.emplace_back();
  const std::map<std::string, int> expected{{"USL-cpGIMP", 1}, {"another", 0}, {"CD-cpGIMP", 2}};
  EXPECT_EQ(series_styles(study), expected);
  study.name = "own";
  EXPECT_EQ(series_styles(study).at("USL-cpGIMP"), 0);
}

}  // namespace mpmvv::reports::series_style_test
