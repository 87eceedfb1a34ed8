#include "reports/figure_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/support/error.hpp"
#include "tests/reports/distinct.hpp"

namespace mpmvv::reports::figure_choice_test {

using testing::ElementsAre;
using testing::IsEmpty;

records::StudyResult study(const std::string& name, const std::string& claim, const std::vector<std::string>& figures) {
  records::StudyResult result = distinct::curves();
  result.name = name;
  result.claims = {claim};
  result.figures.clear();
  for (const auto& figure : figures) result.figures.push_back(distinct::figure(figure, records::Figure::Kind::curves));
  return result;
}

const std::vector<records::StudyResult>& studies() {
  static const std::vector<records::StudyResult> all{
      study("s-fig8", "S-fig8", {"s-fig8", "s-fig8-256"}),
      study("s-fig9", "S-fig9", {"s-fig9a", "s-fig9b", "s-fig9-far"}), study("w-node", "W-node", {"w-node", "nodes"}),
      study("w-node-square", "W-node", {"w-node-square"}), study("x-many", "X-any", {"one", "two"})};
  return all;
}

std::vector<std::string> chosen(const std::string& name, const std::vector<records::StudyResult>& all = studies()) {
  std::vector<std::string> names;
  for (const Chart& chart : choose_figures(all, name).chosen) names.push_back(chart.name);
  return names;
}

TEST(FigureChoice, AFiguresNameMeansIt) {
  EXPECT_THAT(chosen("s-fig8-256"), ElementsAre("s-fig8-256"));
  EXPECT_THAT(choose_figures(studies(), "s-fig8-256").others, IsEmpty());
}

TEST(FigureChoice, AClaimMeansTheFigureOfItsName) {
  EXPECT_THAT(chosen("S-fig8"), ElementsAre("s-fig8"));
  EXPECT_THAT(choose_figures(studies(), "S-fig8").others, ElementsAre("s-fig8-256"));
}

TEST(FigureChoice, AClaimMeansThePanelsOfItsFigure) {
  EXPECT_THAT(chosen("S-fig9"), ElementsAre("s-fig9a", "s-fig9b"));
  EXPECT_THAT(choose_figures(studies(), "S-fig9").others, ElementsAre("s-fig9-far"));
}

TEST(FigureChoice, AClaimWithoutAFigureOfItsNameMeansAllOfItsStudies) {
  EXPECT_THAT(chosen("X-any"), ElementsAre("one", "two"));
  EXPECT_THAT(choose_figures(studies(), "W-node").others, ElementsAre("nodes", "w-node-square"));
}

TEST(FigureChoice, AStudyMeansAllOfItsFigures) {
  EXPECT_THAT(chosen("x-many"), ElementsAre("one", "two"));
}

TEST(FigureChoice, WhatStudiesShareHasTheNameOfEach) {
  const std::vector<records::StudyResult> all{study("a", "S-fig8", {"s-fig8", "own"}),
                                              study("b", "S-fig8", {"s-fig8", "other"})};
  for (const char* name : {"s-fig8", "S-fig8"}) EXPECT_THAT(chosen(name, all), ElementsAre("a~s-fig8", "b~s-fig8"));
  EXPECT_THAT(choose_figures(all, "S-fig8").others, ElementsAre("own", "other"));
  EXPECT_THAT(chosen("b~s-fig8", all), ElementsAre("b~s-fig8"));
  EXPECT_THAT(chosen("a", all), ElementsAre("a~s-fig8", "own"));
}

TEST(FigureChoice, UnknownNamesAreAnsweredWithTheKnownOnes) {
  try {
    choose_figures({studies()[0]}, "s-fig1O");
    FAIL();
  } catch (const support::UsageError& e) {
    EXPECT_STREQ(e.what(), "unknown figure 's-fig1O' (known: s-fig8, s-fig8-256, S-fig8)");
  }
}

TEST(FigureChoice, AClaimOrStudyWithoutAFigureIsNotUnknown) {
  records::StudyResult bare;
  bare.name = "own", bare.claims = {"O-1"};
  const auto message = [&](const std::vector<records::StudyResult>& all, const std::string& name) -> std::string {
    try {
      choose_figures(all, name);
    } catch (const support::UsageError& e) {
      return e.what();
    }
    return "";
  };
  const std::string advice = " has no figure in the store (a [[figure]] in its study file draws one)";
  for (const auto& all : {std::vector{studies()[0], bare}, std::vector{bare}}) {
    EXPECT_EQ(message(all, "O-1"), "claim 'O-1'" + advice);
    EXPECT_EQ(message(all, "own"), "study 'own'" + advice);
  }
  EXPECT_EQ(message({studies()[0], bare}, "O-2"), "unknown figure 'O-2' (known: s-fig8, s-fig8-256, S-fig8)");
  EXPECT_EQ(message({bare}, "O-2"),
            "no figure 'O-2': no study in the store draws one (a [[figure]] in its study file)");
}

TEST(FigureChoice, LettersOfAPaperAreTakenForLarger) {
  EXPECT_EQ(choose_figures(studies(), "one").chosen[0].letter, paper_letter);
}

}  // namespace mpmvv::reports::figure_choice_test
