#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/studies/claims/criterion_samples.hpp"

namespace mpmvv::claims::criterion_replicates_test {

using namespace criterion_samples;
using records::PartVerdict;
using records::Point;

using testing::HasSubstr;

TEST(Criterion, AnOrderOfReplicatesHasTheirInterval) {
  const auto with_replicates = [](StudyResult result, double factor) {
    for (Point& point : result.series[0].points)
      for (const double other : {1 / factor, factor}) point.replicates["l2"].push_back(other * point.y["l2"]);
    return result;
  };
  EXPECT_EQ(verdict_of_order(with_replicates(scattered(0), 1.01), 1.9, {}), PartVerdict::holds);
  EXPECT_EQ(verdict_of_order(with_replicates(scattered(0), 2), 1.9, {}), PartVerdict::inconclusive);
  EXPECT_EQ(verdict_of_order(with_replicates(scattered(1), 1.01), 1.9, {}), PartVerdict::inconclusive)
      << "replicates agree, but their means are no line";
}

/// "good" is h², times 0.9, 1 and 1.1 with replicates; "twice" is twice that, replicate by replicate.
StudyResult with_replicated_errors() {
  StudyResult result = two_series();
  result.series[1] = result.series[0];
  result.series[1].name = "twice";
  for (const double factor : {0.9, 1.0, 1.1})
    for (Point& point : result.series[0].points) point.replicates["l2"].push_back(factor * point.y["l2"]);
  for (std::size_t k = 0; k < 4; ++k)
    for (const double e : result.series[0].points[k].replicates["l2"])
      result.series[1].points[k].replicates["l2"].push_back(2 * e);
  for (Point& point : result.series[1].points) point.y["l2"] *= 2;
  return result;
}

TEST(Criterion, AnErrorOfReplicatesHasTheirInterval) {  // h² and about 28 % to both sides
  const StudyResult result = with_replicated_errors();
  const auto verdict = [&](double at_most) {
    Criterion c = criterion(Kind::error, "good", {}, at_most / 64 / 64);
    c.window = {64, 64};
    return judge(c, result).verdict;
  };
  EXPECT_EQ(verdict(1.3), PartVerdict::holds);
  EXPECT_EQ(verdict(1.2), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0.8), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0.7), PartVerdict::fails);
  EXPECT_THAT(judge(criterion(Kind::error, "good", {}, 1), result).evidence,
              HasSubstr("l2 of 'good' at cells = 8 = 0.01562 (0.0121 to 0.02)"));
}

/// What runs at the same place share is none of their ratio.
TEST(Criterion, ARatioOfReplicatesIsTakenOneByOne) {
  Criterion ratio = criterion(Kind::error_ratio, "twice", 1.99, 2.01);
  ratio.over = "good";
  StudyResult result = with_replicated_errors();
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::holds);
  for (Point& point : result.series[1].points) std::ranges::reverse(point.replicates["l2"]);
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::inconclusive);
  for (Point& point : result.series[1].points) point.replicates["l2"] = {-0.01, 0.01, 0.03};
  EXPECT_EQ(judge(ratio, result).verdict, PartVerdict::inconclusive)
      << "of a ratio whose sign changes nothing is known";
  EXPECT_THAT(judge(ratio, result).evidence, HasSubstr("(without bounds)"));
}

TEST(Criterion, ASpreadOfReplicatesReachesFromTheEndsOfTheirIntervals) {  // 64, and 1.2832² to both sides
  const StudyResult result = with_replicated_errors();
  const auto verdict = [&](std::optional<double> at_least, std::optional<double> at_most) {
    return judge(criterion(Kind::spread, "good", at_least, at_most), result).verdict;
  };
  EXPECT_EQ(verdict({}, 64 * 1.7), PartVerdict::holds);
  EXPECT_EQ(verdict({}, 64 * 1.6), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(64 / 1.6, {}), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(64 / 1.7, {}), PartVerdict::holds);
  EXPECT_EQ(verdict({}, 64 / 1.7), PartVerdict::fails);
  EXPECT_EQ(judge(criterion(Kind::spread, "good", 63.99, 64.01), two_series()).verdict, PartVerdict::holds);
}

TEST(Criterion, ASpreadOfReplicatesOfEitherSignHasNoUpperEnd) {
  StudyResult result = with_replicated_errors();
  result.series[0].points[3].replicates["l2"] = {-1e-4, 1e-4, 3e-4};
  EXPECT_EQ(judge(criterion(Kind::spread, "good", {}, 1e6), result).verdict, PartVerdict::inconclusive);
}

/// Times 0.99, 1 and 1.01 the values 5 and 9 are known to 2.5 %: the slope of 2 to 0.128.
TEST(Criterion, ASlopeOfReplicatesHasTheirInterval) {
  StudyResult result;
  result.sweep = "order";
  result.series = {Series{"slow", {}, {}, {}}, Series{"steep", {}, {}, {}}};
  for (const double x : {1.0, 3.0}) {
    result.series[0].points.push_back({x, Status::ok, "", {{"l2", 3 + 2 * x}}});
    result.series[1].points.push_back({x, Status::ok, "", {{"l2", 3 + 4 * x}}});
  }
  Criterion c = criterion(Kind::slope_ratio, "slow", 0.48, 0.52);
  c.over = "steep", c.window = {1, 3};
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::holds);
  for (Point& point : result.series[0].points)
    for (const double factor : {0.99, 1.0, 1.01}) point.replicates["l2"].push_back(factor * point.y["l2"]);
  EXPECT_THAT(judge(c, result).evidence, HasSubstr("= 0.5 (0.468 to 0.532) (asked"));
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::inconclusive);
  c.at_least = 0.46, c.at_most = 0.54;
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::holds);
}

/// The others lie on the line to the last digit.
TEST(Criterion, AReplicateWithoutALogarithmLeavesTheOrderOpen) {
  StudyResult result = scattered(0);
  for (Point& point : result.series[0].points) point.replicates["l2"] = std::vector<double>(3, point.y["l2"]);
  EXPECT_EQ(verdict_of_order(result, 1.9, {}), PartVerdict::holds);
  result.series[0].points[0].replicates["l2"][2] = -0.1;
  EXPECT_EQ(verdict_of_order(result, 1.9, {}), PartVerdict::inconclusive);
  EXPECT_THAT(judge(criterion(Kind::order, "good", 1.9, {}), result).evidence,
              HasSubstr("; 'good' has a replicate with l2 not above 0 at cells = 8 (asked"));
}

TEST(Criterion, AnOrderDifferenceNamesTheNormWhoseReplicateHasNoLogarithm) {
  StudyResult result = scattered(0);
  for (Point& point : result.series[0].points) {
    point.y["linf"] = 2 * point.y["l2"];
    for (const char* norm : {"l2", "linf"}) point.replicates[norm] = std::vector<double>(3, point.y[norm]);
  }
  Criterion c = criterion(Kind::order_difference, "good", -0.1, 0.1);
  c.over_norm = "linf";
  EXPECT_EQ(judge(c, result).verdict, PartVerdict::holds) << judge(c, result).evidence;
  result.series[0].points[0].replicates["linf"][2] = -0.1;
  EXPECT_THAT(judge(c, result).evidence, HasSubstr("'good' has a replicate with linf not above 0 at cells = 8"));
}

}  // namespace mpmvv::claims::criterion_replicates_test
