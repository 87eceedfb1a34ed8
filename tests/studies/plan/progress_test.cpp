#include "studies/plan/progress.hpp"

#include <gtest/gtest.h>

namespace mpmvv::plan::progress_test {

cases::Case sized(int cells) {
  cases::Case c;
  c.resolution.cells = cells;
  return c;
}

cases::Case timed(int cells) {
  cases::Case c = sized(cells);
  c.measure.repeat = 5;
  return c;
}

TEST(Remaining, SharesTheWorkButDoesNotDivideACase) {
  Remaining remaining;
  EXPECT_EQ(remaining.seconds(2), 0);
  for (int cells : {1, 2, 3, 4}) remaining.add(sized(cells), 10);
  EXPECT_DOUBLE_EQ(remaining.seconds(1), 40);
  EXPECT_DOUBLE_EQ(remaining.seconds(2), 20);
  EXPECT_DOUBLE_EQ(remaining.seconds(16), 10);
  remaining.finish(sized(1), 10);
  EXPECT_DOUBLE_EQ(remaining.seconds(1), 30);
}

TEST(Remaining, WhatIsTimedComesAfterTheRest) {
  Remaining remaining;
  remaining.add(sized(1), 10);
  for (int cells : {1, 2}) remaining.add(timed(cells), 3);
  EXPECT_DOUBLE_EQ(remaining.seconds(4), 16);
}

TEST(Remaining, IsCorrectedByWhatHasFinished) {
  Remaining remaining;
  for (int cells : {1, 2}) remaining.add(sized(cells), 100);
  remaining.finish(sized(1), 200);
  EXPECT_NEAR(remaining.seconds(1), 200, 5) << "on a machine of half the speed";
  remaining.finish(sized(7), 1000);
  EXPECT_NEAR(remaining.seconds(1), 200, 5) << "nobody has asked for it";
}

TEST(Remaining, ExpectsWhatIsNotKnownByItsCasesYet) {
  Remaining remaining;
  remaining.expect(8);
  EXPECT_DOUBLE_EQ(remaining.seconds(2), 4);
  remaining.expect(-8);
  remaining.add(sized(1), 3);
  EXPECT_DOUBLE_EQ(remaining.seconds(1), 3);
}

}  // namespace mpmvv::plan::progress_test
