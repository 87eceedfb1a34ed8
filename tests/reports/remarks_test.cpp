#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/chart.hpp"
#include "reports/orders_table.hpp"
#include "reports/paper.hpp"
#include "reports/picture.hpp"
#include "studies/store/trial.hpp"
#include "tests/reports/distinct.hpp"
#include "tests/reports/synthetic.hpp"
#include "tests/reports/temp_folder.hpp"

/// What a figure says of trials and of what it leaves out.
namespace mpmvv::reports::remarks_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

records::StudyResult trial_of(records::StudyResult study) {
  study.text = store::with_trial(study.text, "smoothing_length = 3 in 2 of 2 series");
  return study;
}

/// A study whose figure has no place for one point.
records::StudyResult with_a_gain() {
  records::StudyResult study = distinct::laws();
  study.series[2].points[3].y["l2"] = -2;
  return study;
}

std::string document_of(const records::StudyResult& study) {
  const TempFolder folder;
  Sheet column;
  column.format = Format::tex;
  write_paper({study}, {}, folder.path(), column);
  return content(folder / "main.tex");
}

TEST(Remarks, EveryFigureOfATrialSaysSo) {
  const records::StudyResult study = trial_of(distinct::laws());
  const std::string sentence = "Made with --set: smoothing_length = 3 in 2 of 2 series.";
  const TempFolder folder;
  const auto pictures = pictures_of(charts_of(study), folder.path(), "figures");
  EXPECT_EQ(pictures.at(0).caption, "Caption of laws. " + sentence);
  EXPECT_THAT(document_of(study),
              HasSubstr("\\caption{laws. Caption of laws. Made with -{}-set: smoothing\\_length = 3 "
                        "in 2 of 2 series.}"));
  EXPECT_THAT(orders_table({&study}).groups.at(0).title, HasSubstr(sentence));
  EXPECT_EQ(charts_of(distinct::laws()).at(0).trial, "");
}

TEST(Remarks, AMapThatNoStudyAskedForSaysItToo) {
  records::StudyResult study = trial_of(distinct::limits());
  study.figures.clear();
  const auto charts = charts_of(study);
  ASSERT_EQ(charts.size(), 1U);
  EXPECT_EQ(charts[0].name, "limits-map");
  EXPECT_EQ(charts[0].trial, "Made with --set: smoothing_length = 3 in 2 of 2 series.");
}

TEST(Remarks, WhatAFigureLeavesOutStandsInItsCaption) {
  const records::StudyResult study = with_a_gain();
  const auto charts = charts_of(study);
  ASSERT_EQ(charts.at(0).omissions.size(), 1U);
  const std::string omission = charts[0].omissions[0];
  EXPECT_THAT(omission, AllOf(HasSubstr("Without a point: law 2 at "), HasSubstr(" (-2).")));
  EXPECT_THAT(document_of(study), HasSubstr("\\caption{laws. Caption of laws. " + omission + "}"));
  const TempFolder folder;
  EXPECT_THAT(pictures_of(charts, folder.path(), "figures").at(0).notes.back(), omission);
  for (const std::string& note : charts[0].notes) EXPECT_NE(note, omission);
}

TEST(Remarks, LeftOutOfAnOrderIsAnOmission) {
  records::StudyResult study = synthetic::convergence();
  study.figures[0].series = {"bspline2, 4 PPC"};
  study.series[1].points[1].y["output_floor"] = 1;
  const auto omissions = charts_of(study).at(0).omissions;
  EXPECT_THAT(omissions, ElementsAre(testing::StartsWith("Left out of the order of bspline2, 4 PPC: ")));
}

}  // namespace mpmvv::reports::remarks_test
