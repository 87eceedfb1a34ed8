#include "studies/claims/samples.hpp"

#include <gtest/gtest.h>

namespace mpmvv::samples_test {

/// Second order until the digits of the output show.
records::Series with_floor() {
  records::Series series;
  for (const double cells : {8.0, 16.0, 32.0, 64.0})
    series.points.push_back(
        {.x = cells, .reason = "", .y = {{"l2", 1 / cells / cells}, {"stress_error", 1e-9}, {"output_floor", 1e-4}}});
  series.points.back().y["l2"] = 2.9e-4;
  return series;
}

TEST(Samples, NoOrderIsTakenNearTheFloorOfAnOutput) {
  const records::Series series = with_floor();
  EXPECT_EQ(claims::samples_of(series, "l2", "cells").size(), 3U);
  EXPECT_EQ(claims::left_out(series, "l2"),
            "64 (within 3 times the error that the rounding of the code's output makes)");
  const auto fit = fits::fit_order(claims::samples_of(series, "l2", "cells"), 8, 64);
  EXPECT_EQ(fit.points, 3);
  EXPECT_NEAR(fit.order, 2, 1e-12);
}

/// Of two floors each leaves out its own points.
TEST(Samples, NoOrderIsTakenNearTheErrorOfTheSolution) {
  records::Series series = with_floor();
  for (records::Point& point : series.points) point.y["solution_floor"] = 1.5e-3;
  EXPECT_EQ(claims::left_out(series, "l2"),
            "64 (within 3 times the error that the rounding of the code's output makes), "
            "16, 32 (within 3 times the error of the solution, which is not exact for the law)");
  EXPECT_EQ(claims::samples_of(series, "l2", "cells").size(), 1U);
}

/// h is the distance of particles: twice as many a cell halve it.
TEST(Samples, MoreParticlesAreAFinerStep) {
  for (const char* sweep : {"cells", "ppc"}) {
    const auto fit = fits::fit_order(claims::samples_of(with_floor(), "l2", sweep), 8, 32);
    EXPECT_NEAR(fit.order, 2, 1e-12) << sweep;
    EXPECT_TRUE(claims::is_finer(32, 8, sweep)) << sweep;
  }
  EXPECT_NEAR(fits::fit_order(claims::samples_of(with_floor(), "l2", "cfl"), 8, 32).order, -2, 1e-12);
  EXPECT_TRUE(claims::is_finer(8, 32, "cfl"));
}

TEST(Samples, AHigherOrderAndADeeperWallAreFinerButNoSteps) {
  for (const char* sweep : {"order", "wall_depth"}) {
    EXPECT_TRUE(claims::is_finer(4, 2, sweep)) << sweep;
    EXPECT_FALSE(claims::is_finer(2, 4, sweep)) << sweep;
    EXPECT_EQ(claims::step_size(4, sweep), 4) << sweep;
  }
}

TEST(Samples, OtherErrorsHaveNoFloor) {
  EXPECT_EQ(claims::samples_of(with_floor(), "stress_error", "cells").size(), 4U);
  EXPECT_TRUE(claims::left_out(with_floor(), "stress_error").empty());
}

}  // namespace mpmvv::samples_test
