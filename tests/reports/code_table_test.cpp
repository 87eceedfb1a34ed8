#include "reports/code_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mpmvv::reports::code_table_test {

using testing::HasSubstr;

ReportInput input_with_codes() {
  ReportInput input;
  records::StudyResult study;
  study.name = "theirs";
  study.series = {{"tlmpm", {}, {}, {}}, {"ours", {}, {}, {}}};
  fits::ObservedOrder order;
  order.order = 2.01, order.half_width = 0.05, order.from = 8, order.to = 64, order.norm = "l2";
  study.series[0].orders.push_back(order);
  records::ClaimPart part;
  part.claim = "second", part.statement = "second order", part.verdict = records::PartVerdict::holds;
  part.found = {{"order of 'tlmpm' in l2 over [8, 64]", 2.01}};
  study.parts = {part};
  input.studies = {study};
  claims::Claim claim;
  claim.id = "second", claim.statement = "the total form is second order",
  claim.verdict = claims::Claim::Verdict::confirmed;
  input.claims = {claim};
  input.codes = {{"theirs", "tlmpm", {"karamelo", "2.0", "tlmpm-linear", "reference"}, "2026-11-25T10:00:00Z"}};
  return input;
}

TEST(CodeTable, HasARowForEachSeriesOfAnotherCode) {
  const Table table = code_table(input_with_codes());
  ASSERT_EQ(table.groups.size(), 1U);
  EXPECT_EQ(table.groups[0].title, "karamelo 2.0");
  ASSERT_EQ(table.groups[0].rows.size(), 1U);
  const auto& row = table.groups[0].rows[0];
  EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(row[2], "tlmpm-linear");
  EXPECT_EQ(row[4], "2026-11-25");
  EXPECT_THAT(row[5], HasSubstr("2.01"));
  EXPECT_EQ(row[6], "second order: holds");
  EXPECT_EQ(row[7], "the total form is second order (confirmed)");
}

TEST(CodeTable, SaysUpToWhereASeriesIsStable) {
  ReportInput input = input_with_codes();
  records::Series& series = input.studies[0].series[0];
  series.orders.clear();
  series.limit.emplace();
  series.limit->key = "cfl", series.limit->stable = 0.7, series.limit->unstable = 0.72, series.limit->found = true;
  EXPECT_EQ(code_table(input).groups[0].rows[0][5], "stable at 0.7, unstable at 0.72 in cfl");
  series.limit->monotone = false;
  EXPECT_EQ(code_table(input).groups[0].rows[0][5], "stable at 0.7, unstable at 0.72 in cfl, not monotone");
  series.limit->found = false, series.limit->unstable = records::not_measured;
  series.limit->probes = {{0.35, true, ""}, {0.7, true, ""}};
  EXPECT_EQ(code_table(input).groups[0].rows[0][5], "no limit in cfl: stable at all values tried, up to 0.7");
}

/// One name may begin another.
TEST(CodeTable, SaysOfASeriesWhatWasAskedOfThatOne) {
  ReportInput input = input_with_codes();
  input.studies[0].series.push_back({"tlmpm, no b", {}, {}, {}});
  input.studies[0].parts[0].found[0].what = "l2 of 'tlmpm, no b' over 'tlmpm' at 16";
  EXPECT_EQ(code_table(input).groups[0].rows[0][6], "–");
}

TEST(CodeTable, SaysWhichErrorsAnOrderLeavesOut) {
  ReportInput input = input_with_codes();
  input.studies[0].series[0].points = {{.x = 32, .reason = "", .y = {{"l2", 1e-6}, {"solution_floor", 1e-6}}}};
  EXPECT_THAT(code_table(input).groups[0].rows[0][5], HasSubstr("8 to 64 without 32 (within 10 times"));
}

TEST(CodeTable, HasAGroupForEachVersion) {
  ReportInput input = input_with_codes();
  input.codes.push_back(input.codes[0]);
  input.codes.back().code.version = "1.9";
  const Table table = code_table(input);
  ASSERT_EQ(table.groups.size(), 2U);
  EXPECT_EQ(table.groups[0].title, "karamelo 1.9");
}

TEST(CodeTable, IsEmptyWithoutOne) {
  EXPECT_TRUE(code_table(ReportInput{}).empty());
}

/// A study may be kept anew in the store while a report is made.
TEST(CodeTable, LeavesOutWhatNoStudyHas) {
  ReportInput input = input_with_codes();
  for (const auto& [study, series] : {std::pair{"gone", "tlmpm"}, {"theirs", "gone"}}) {
    input.codes.push_back(input.codes[0]);
    input.codes.back().study = study, input.codes.back().series = series, input.codes.back().code.version = "3.0";
  }
  const Table table = code_table(input);
  ASSERT_EQ(table.groups.size(), 1U);
  EXPECT_EQ(table.groups[0].title, "karamelo 2.0");
  EXPECT_EQ(table.groups[0].rows.size(), 1U);
}

}  // namespace mpmvv::reports::code_table_test
