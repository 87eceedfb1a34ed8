#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/page.hpp"

namespace mpmvv::reports::study_page_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A study of three series, the last two by another code.
records::StudyResult study_of_codes() {
  records::StudyResult study;
  study.name = "bars", study.title = "Bars", study.sweep = "cells";
  records::Series series{"ours", {{8, records::Status::ok, "", {{"l2", 1e-3}}}}, {}, {}};
  study.series = {series};
  series.name = "theirs <1>", series.code = records::OtherCode{"strata", "2.4", "", "reference"};
  study.series.push_back(series);
  series.name = "theirs 2";
  study.series.push_back(series);
  return study;
}

std::string page_of(const ReportInput& input) {
  return study_page(input, {&input.studies.at(0), {}, {}}).text;
}

TEST(StudyPage, NamesTheVersionsOfOtherCodesAndTheirSeries) {
  ReportInput input;
  input.studies = {study_of_codes()};
  EXPECT_THAT(page_of(input), HasSubstr("<p class=\"soft\">Run by strata 2.4: theirs &lt;1&gt;; theirs 2</p>"));
  input.codes = {{"bars", "theirs 2", *input.studies[0].series[2].code, "2026-11-25T10:00:00Z"}};
  EXPECT_THAT(page_of(input), HasSubstr("Run by <a href=\"../codes.html\">strata 2.4</a>: theirs"));
  input.studies[0].series.resize(1);
  EXPECT_THAT(page_of(input), Not(HasSubstr("Run by")));
}

TEST(StudyPage, EnergiesHaveTheUnitOfTheBodies) {
  ReportInput input;
  input.studies = {study_of_codes()};
  for (records::Series& series : input.studies[0].series) series.points[0].y["kinetic"] = 2;
  EXPECT_THAT(page_of(input), HasSubstr("kinetic = 2 J, in 2D J/m, in 1D J/m²"));
  input.dimensions["bars"] = 1;
  EXPECT_THAT(page_of(input), HasSubstr("kinetic = 2 J/m²."));
}

TEST(StudyPage, ARunToRepeatSaysWhichVersionOfACodeRanIt) {
  ReportInput input;
  input.studies = {study_of_codes()};
  input.studies[0].series[1].code->version = "0123456789abcdef0123";
  input.commands["bars"] = {{"ours", "run {}", ""}, {"theirs <1>", "run {}", ""}, {"theirs 2", "run {}", "the first"}};
  EXPECT_THAT(page_of(input), AllOf(HasSubstr("<p class=\"soft\">ours</p>"),
                                    HasSubstr("<p class=\"soft\">theirs &lt;1&gt; (strata 0123456789ab)</p>"),
                                    HasSubstr("<p class=\"soft\">theirs 2 (strata 2.4, the first)</p>")));
}

}  // namespace mpmvv::reports::study_page_test
