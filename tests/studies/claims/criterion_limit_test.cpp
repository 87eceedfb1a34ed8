#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/studies/claims/criterion_samples.hpp"

namespace mpmvv::claims::criterion_limit_test {

using namespace criterion_samples;
using records::PartVerdict;

using testing::HasSubstr;

TEST(CriterionOfLimits, ARatioOfLimitsReachesFromTheEndsOfBothBrackets) {  // [1, 1.5] over [2, 4]
  StudyResult result = two_series();
  result.series[1].limit = result.series[0].limit;
  result.series[0].limit->stable = 1, result.series[0].limit->unstable = 1.5;
  result.series[1].limit->stable = 2, result.series[1].limit->unstable = 4;
  const auto verdict = [&result](std::optional<double> at_least, std::optional<double> at_most) {
    Criterion ratio = criterion(Kind::limit_ratio, "good", at_least, at_most);
    ratio.over = "bad";
    return judge(ratio, result).verdict;
  };
  EXPECT_EQ(verdict(0.25, 0.75), PartVerdict::holds);
  EXPECT_EQ(verdict(0.26, {}), PartVerdict::inconclusive);
  EXPECT_EQ(verdict({}, 0.74), PartVerdict::inconclusive);
  EXPECT_EQ(verdict(0.76, {}), PartVerdict::fails);
  EXPECT_EQ(verdict({}, 0.24), PartVerdict::fails);
  result.series[0].limit->found = false;  // above 1, over [2, 4]: above 0.25
  result.series[0].limit->unstable = NAN;
  result.series[0].limit->probes = {{0.5, true, ""}, {1, true, ""}};
  EXPECT_EQ(verdict(0.25, {}), PartVerdict::holds);
  EXPECT_EQ(verdict(0.26, {}), PartVerdict::inconclusive);
  EXPECT_EQ(verdict({}, 0.24), PartVerdict::fails);
  std::swap(result.series[0].limit, result.series[1].limit);  // [2, 4] over what is above 1: below 4
  EXPECT_EQ(verdict({}, 4), PartVerdict::holds);
  EXPECT_EQ(verdict(4.1, {}), PartVerdict::fails);
  result.series[0].limit = result.series[1].limit;
  EXPECT_EQ(verdict({}, 4), PartVerdict::inconclusive) << "nothing is known of their ratio";
}

TEST(CriterionOfLimits, ARatioOfLimitsSaysWhichIsNotMonotone) {
  StudyResult result = two_series();
  result.series[1].limit = result.series[0].limit;
  Criterion ratio = criterion(Kind::limit_ratio, "good", 0.5, {});
  ratio.over = "bad";
  const auto remark = [&] { return judge(ratio, result).found[0].remark; };
  EXPECT_EQ(remark(), "");
  result.series[1].limit->monotone = false;
  EXPECT_EQ(remark(), "that of 'bad' not monotone");
  result.series[0].limit->monotone = false;
  EXPECT_EQ(remark(), "that of 'good' and 'bad' not monotone");
  result.series[1].limit->monotone = true;
  result.series[1].limit->probes = {{0.99, true, "", 8}, {1.01, false, "", 8}};
  EXPECT_EQ(remark(),
            "that of 'good' not monotone, and that of 'bad' only 8 steps at 0.99, where growth that doubles "
            "on each shows from 40 on")
      << "\"; \" would part numbers";
}

TEST(CriterionOfLimits, ReplicatesThatShareOneEndOfALimitDecideByIt) {
  StudyResult result = two_series();
  fits::StabilityLimit& limit = *result.series[0].limit;  // one is stable up to 1, the other throughout
  limit.stable = 1, limit.unstable = NAN, limit.found = false;
  limit.probes = {{0.5, true, ""}, {0.5, true, ""}, {1, true, ""}, {1.5, false, ""}, {1.5, true, ""}};
  const auto judged = [&](double at_least) { return judge(criterion(Kind::limit, "good", at_least, {}), result); };
  EXPECT_EQ(judged(0.9).verdict, PartVerdict::holds);
  EXPECT_EQ(judged(1.2).verdict, PartVerdict::inconclusive);
  EXPECT_THAT(judged(0.9).evidence, HasSubstr("replicates disagree = 1 or more (asked"));
}

TEST(CriterionOfLimits, RunsOfFewStepsDoNotShowThatALimitIsNoLower) {
  StudyResult result = two_series();
  fits::StabilityLimit& limit = *result.series[0].limit;  // stable up to 2, from 0.4 on in fewer than 40 steps
  limit.stable = 2, limit.unstable = NAN, limit.found = false;
  limit.probes = {{0.2, true, "", 80}, {0.4, true, "", 40}, {2, true, "", 8}};
  const auto judged = [&](double at_least) { return judge(criterion(Kind::limit, "good", at_least, {}), result); };
  EXPECT_EQ(judged(0.4).verdict, PartVerdict::holds);
  EXPECT_EQ(judged(0.41).verdict, PartVerdict::inconclusive);
  EXPECT_THAT(judged(0.41).evidence,
              HasSubstr("= 0.4 or more (only 8 steps at 2, where growth that doubles on each shows from 40 on)"));
  limit.probes = {{0.2, true, "", 30}, {2, true, "", 3}};
  EXPECT_THAT(judged(0.1).evidence,
              HasSubstr("no limit: stable at all values tried, up to 2, only 3 steps at 2, where growth"));
  limit.found = true, limit.unstable = 2.1;  // an unstable run needs no steps to show that the limit is no higher
  limit.probes.push_back({2.1, false, "energy", 2});
  EXPECT_EQ(judge(criterion(Kind::limit, "good", {}, 2.1), result).verdict, PartVerdict::holds);
  EXPECT_EQ(judge(criterion(Kind::limit, "good", {}, 1.9), result).verdict, PartVerdict::inconclusive);
}

}  // namespace mpmvv::claims::criterion_limit_test
