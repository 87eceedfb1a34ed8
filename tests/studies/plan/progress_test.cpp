#include "studies/plan/progress.hpp"

#include <gtest/gtest.h>

#include "studies/settings/settings.hpp"

namespace mpmvv::plan::progress_test {

/// Cases with enough particles to share.
cases::Case sized(int cells) {
  const std::vector<settings::Setting> bar{{"problem", "bar", ""},
                                           {"cells", std::to_string(400 + cells), ""},
                                           {"ppc", "4", ""},
                                           {"cfl", "0.2", ""},
                                           {"basis", "bspline2", ""}};
  return settings::make_case(bar);
}

cases::Case timed(int cells) {
  cases::Case c = sized(cells);
  c.measure.repeat = 5;
  return c;
}

TEST(Remaining, SharesTheWorkButDoesNotDivideACase) {
  Remaining remaining;
  EXPECT_EQ(remaining.seconds(2), 0);
  for (int cells : {1, 2, 3, 4}) remaining.add(sized(cells), 4);
  EXPECT_DOUBLE_EQ(remaining.seconds(1), 16);
  EXPECT_DOUBLE_EQ(remaining.seconds(2), 8);
  EXPECT_DOUBLE_EQ(remaining.seconds(16), 4);
  remaining.finish(sized(1), 4);
  EXPECT_DOUBLE_EQ(remaining.seconds(1), 12);
}

TEST(Remaining, DividesALongCaseUnlessAnotherCodeRunsIt) {
  Remaining ours, theirs;
  cases::Case of_another_code = sized(1);
  of_another_code.scheme.code = "mover";
  ours.add(sized(1), 40), theirs.add(of_another_code, 40);
  EXPECT_DOUBLE_EQ(ours.seconds(4), 10);
  EXPECT_DOUBLE_EQ(theirs.seconds(4), 40);
}

TEST(Remaining, WhatIsTimedComesAfterTheRest) {
  Remaining remaining;
  remaining.add(sized(1), 4);
  for (int cells : {1, 2}) remaining.add(timed(cells), 3);
  EXPECT_DOUBLE_EQ(remaining.seconds(4), 4 + 2 * 2.5) << "the first run of each is beside the rest";
  EXPECT_DOUBLE_EQ(remaining.seconds(1), 10);
  remaining.add(timed(3), 60);
  EXPECT_DOUBLE_EQ(remaining.seconds(4), 10 + 2 * 2.5 + 50) << "its first run of ten seconds is one thread's";
}

TEST(Remaining, IsCorrectedByWhatHasFinished) {
  Remaining remaining;
  for (int cells : {1, 2}) remaining.add(sized(cells), 100);
  remaining.finish(sized(1), 200);
  EXPECT_NEAR(remaining.seconds(1), 200, 5) << "on a machine of half the speed";
  remaining.finish(sized(7), 1000);
  EXPECT_NEAR(remaining.seconds(1), 200, 5) << "nobody has asked for it";
}

TEST(Remaining, ARunThatFailedSaysNothingOfTheOthers) {
  Remaining remaining;
  for (int cells : {1, 2}) remaining.add(sized(cells), 100);
  remaining.finish(sized(1), support::not_measured);
  EXPECT_DOUBLE_EQ(remaining.seconds(1), 100);
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
