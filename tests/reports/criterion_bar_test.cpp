#include "reports/criterion_bar.hpp"

#include <gmock/gmock.h>

#include "reports/criteria.hpp"

namespace mpmvv::reports::criterion_bar_test {

using testing::HasSubstr;
using testing::Not;

/// From 0 to 1, where a number is found at 0.9; the scale goes from -0.35 to 1.35.
TEST(CriterionBar, ShowsAnIntervalThatReachesOutOfTheBand) {
  records::ClaimPart part;
  part.at_least = 0, part.at_most = 1;
  part.found = {{"order", 0.9}};
  EXPECT_THAT(criterion_bar(part, 0.9, {0.9, 0.9}), Not(HasSubstr("reach")));
  const std::string bar = criterion_bar(part, 0.9, {0.7, 1.1});
  EXPECT_THAT(bar, HasSubstr(R"(<path class="reach" d="M57.6 7H76.9"/>)"));
  EXPECT_THAT(bar, HasSubstr("within"));
  EXPECT_THAT(criterion_bar(part, 0.9, {0.9, HUGE_VAL}), HasSubstr(R"(<path class="reach" d="M67.3 7H89"/>)"));
  EXPECT_EQ(criterion_bar({}, 0.9, {0.7, 1.1}), "") << "nothing was asked";
}

TEST(IntervalText, SaysOnWhichSideALimitLies) {
  records::ClaimPart part;
  part.evidence = "cfl limit of 'a', unstable at all values tried, down to 0.25: below 0.25 (asked: at least 0.8)";
  EXPECT_EQ(interval_text(part, {"cfl limit of 'a', unstable at all values tried, down to 0.25", 0.25}), " or less");
  part.evidence = "cfl limit of 'a', stable at all values tried, up to 1: above 1 (asked: at least 0.8)";
  EXPECT_EQ(interval_text(part, {"cfl limit of 'a', stable at all values tried, up to 1", 1}), " or more");
}

}  // namespace mpmvv::reports::criterion_bar_test
