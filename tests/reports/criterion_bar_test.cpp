#include "reports/criterion_bar.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace mpmvv::reports::criterion_bar_test {

using testing::HasSubstr;
using testing::Not;

/// From 0 to 1, where a number is found at 0.9; the scale goes from -0.35 to 1.35.
TEST(CriterionBar, ShowsAnIntervalThatReachesOutOfTheBand) {
  records::ClaimPart part;
  part.at_least = 0, part.at_most = 1;
  part.found = {{"order", 0.9}};
  EXPECT_THAT(criterion_bar(part, part.found[0]), Not(HasSubstr("reach")));
  EXPECT_THAT(criterion_bar(part, {"order", 0.9, 0.9, 0.9 + 1e-15}), Not(HasSubstr("reach"))) << "round-off";
  const std::string bar = criterion_bar(part, {"order", 0.9, 0.7, 1.1});
  EXPECT_THAT(bar, HasSubstr(R"(<path class="reach" d="M57.6 7H76.9"/>)"));
  EXPECT_THAT(bar, HasSubstr("within"));
  EXPECT_THAT(criterion_bar(part, {"order", 0.9, 0.9, HUGE_VAL}), HasSubstr(R"(<path class="reach" d="M67.3 7H89"/>)"));
  EXPECT_EQ(criterion_bar({}, {"order", 0.9, 0.7, 1.1}), "") << "nothing was asked";
}

}  // namespace mpmvv::reports::criterion_bar_test
