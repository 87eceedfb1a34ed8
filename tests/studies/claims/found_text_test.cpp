#include "studies/claims/found_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// What stands behind a number that was found, by what was measured.
namespace mpmvv::claims::found_text_test {

constexpr double without_end = HUGE_VAL;

std::string beside(const std::string& measure, const records::Found& found) {
  records::ClaimPart part;
  part.measure = measure;
  return interval_and_remark(part, found);
}

TEST(RangeText, HasAsManyDigitsAsTellItsEndsApart) {
  EXPECT_EQ(range_text(0.99969, 1.00045), "0.9997 to 1");
  EXPECT_EQ(range_text(0.3, 0.7), "0.3 to 0.7");
  EXPECT_EQ(range_text(1, 1 + 1e-14), "");
  EXPECT_EQ(range_text(-without_end, without_end), "without bounds");
  EXPECT_EQ(range_text(-without_end, 1), "without bounds");
}

TEST(HasInterval, OfMoreThanRoundOffAroundANumber) {
  EXPECT_TRUE(has_interval({"limit", 1, 1, without_end}));
  EXPECT_FALSE(has_interval({"cost", 0.25, 0.25, 0.25 + 1e-16}));
  EXPECT_FALSE(has_interval({"cost", without_end, -without_end, without_end}));
  EXPECT_FALSE(has_interval({"order"}));
}

TEST(IntervalText, HasNoRemark) {
  records::ClaimPart part;
  part.measure = "order";
  EXPECT_EQ(interval_text(part, {"order", 2, 1.9, 2.1, "finest segment 1.41"}), " ± 0.1");
}

TEST(IntervalText, OfAnOrderIsHalfItsWidthAndSaysWhereTheFinestSegmentLies) {
  EXPECT_EQ(beside("order", {"order", 2, 1.74, 2.26}), " ± 0.26");
  EXPECT_EQ(beside("order-difference", {"order", 2, 1.9, 2.1, "finest segment 1.41"}), " ± 0.1 (finest segment 1.41)");
  EXPECT_EQ(beside("order", {"order", 2}), "");
  EXPECT_EQ(beside("order", {"order", -without_end}), "") << "unstable";
}

TEST(IntervalText, OfTimesAndReplicatesIsTheirRange) {
  EXPECT_EQ(beside("cost-ratio", {"cost", 0.5, 0.3, 0.7}), " (0.3 to 0.7)");
  EXPECT_EQ(beside("slope-ratio", {"cost", 0.5, 0.3, 0.7, "not timed in the same rounds"}),
            " (0.3 to 0.7, not timed in the same rounds)");
  EXPECT_EQ(beside("error", {"l2", 0.5, -without_end, without_end}), " (without bounds)");
  EXPECT_EQ(beside("error-ratio", {"l2", 1, 1, 1, "both unstable"}), " (both unstable)");
  EXPECT_EQ(beside("error", {"l2", without_end}), "");
}

TEST(IntervalText, OfALimitSaysOnWhichSideItLies) {
  EXPECT_EQ(beside("limit", {"limit", 0.25, 0, 0.25}), " or less");
  EXPECT_EQ(beside("limit-ratio", {"limit", 1, 1, without_end}), " or more");
  EXPECT_EQ(beside("limit", {"limit between 0.4 and 0.5", 0.45, 0.4, 0.5}), "") << "its name has the bracket";
  EXPECT_EQ(beside("limit", {"limit between 0.4 and 0.5", 0.45, 0.4, 0.5, "not monotone"}), " (not monotone)");
}

}  // namespace mpmvv::claims::found_text_test
