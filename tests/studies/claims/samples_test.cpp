#include "studies/claims/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

std::ptrdiff_t count_errors(const std::vector<fits::ErrorSample>& samples) {
  return std::ranges::count_if(samples, [](const fits::ErrorSample& s) { return !std::isnan(s.e); });
}

TEST(Samples, NoOrderIsTakenNearTheFloorOfAnOutput) {
  const records::Series series = with_floor();
  EXPECT_EQ(count_errors(claims::samples_of(series, "l2", "cells")), 3);
  EXPECT_EQ(claims::left_out(series, "l2"),
            "64 (within 3 times the error that the rounding of the code's output makes)");
  const auto fit = fits::fit_order(claims::samples_of(series, "l2", "cells"), 8, 64);
  EXPECT_EQ(fit.points, 3);
  EXPECT_NEAR(fit.order, 2, 1e-12);
}

/// Of two floors each leaves out its own points.
TEST(Samples, NoOrderIsTakenNearTheErrorOfTheSolution) {
  records::Series series = with_floor();
  for (records::Point& point : series.points) point.y["solution_floor"] = 4.5e-4;
  EXPECT_EQ(claims::left_out(series, "l2"),
            "64 (within 3 times the error that the rounding of the code's output makes), "
            "16, 32 (within 10 times the error of the solution, which is not exact for the law)");
  EXPECT_EQ(count_errors(claims::samples_of(series, "l2", "cells")), 1);
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

TEST(Samples, AnExtrapolationEndsWhereTheStepIsZero) {
  EXPECT_EQ(claims::extrapolated_to("cells"), "h = 0");
  EXPECT_EQ(claims::extrapolated_to("ppc"), "1/ppc = 0");
  EXPECT_EQ(claims::extrapolated_to("dt"), "dt = 0");
  EXPECT_EQ(claims::finest_level("cells"), "finest grid");
  EXPECT_EQ(claims::finest_level("ppc"), "largest ppc");
  EXPECT_EQ(claims::finest_level("cfl"), "smallest cfl");
}

TEST(Samples, AFitSaysHowManyPointsOfItsWindowItTakes) {
  fits::ObservedOrder order;
  order.from = 8, order.to = 32, order.points = 3;
  EXPECT_EQ(claims::points_text(with_floor(), order), "3");
  order.to = 64;
  EXPECT_EQ(claims::points_text(with_floor(), order), "3 of 4");
}

/// A first-order error of runs that take 1, 2, 3 and 6 steps to the end time 1, for Courant numbers of 1, 0.6, 0.4,
/// 0.2.
TEST(Samples, TheStepOfACourantNumberIsThatOfTheRun) {
  records::Series series;
  const std::pair<double, double> steps[] = {{0.2, 1. / 6}, {0.4, 1. / 3}, {0.6, 1. / 2}, {1, 1}};
  for (const auto& [asked, run] : steps)
    series.points.push_back(
        {.x = asked, .reason = "", .y = {{"l2", run}, {"cfl", run}}, .replicates = {{"l2", {run, run}}}});
  EXPECT_NEAR(fits::fit_order(claims::samples_of(series, "l2", "cfl"), 0.2, 1).order, 1, 1e-12);
  for (const auto& sample : claims::replicate_samples_of(series, "l2", "cfl")) EXPECT_EQ(sample.h, sample.e);
  for (records::Point& point : series.points) point.y.erase("cfl");
  EXPECT_EQ(claims::samples_of(series, "l2", "cfl")[0].h, 0.2) << "of a check's curve it is not known";
}

TEST(Samples, AWindowWithAnUnstableRunBetweenOthersIsNotAsymptotic) {
  records::Series series = with_floor();
  series.points.back().y["l2"] = 1. / 64 / 64;
  for (records::Point& point : series.points) point.y.erase("output_floor");
  const auto is_asymptotic = [&] {
    return fits::fit_order(claims::samples_of(series, "l2", "cells"), 8, 64).asymptotic;
  };
  EXPECT_TRUE(is_asymptotic());
  series.points[1].status = records::Status::unstable;
  EXPECT_FALSE(is_asymptotic());
}

TEST(Samples, AHigherOrderAndADeeperWallAreFinerButNoSteps) {
  for (const char* sweep : {"order", "wall_depth"}) {
    EXPECT_TRUE(claims::is_finer(4, 2, sweep)) << sweep;
    EXPECT_FALSE(claims::is_finer(2, 4, sweep)) << sweep;
    EXPECT_EQ(claims::step_size(4, sweep), 4) << sweep;
  }
}

TEST(Samples, OtherErrorsHaveNoFloor) {
  EXPECT_EQ(count_errors(claims::samples_of(with_floor(), "stress_error", "cells")), 4);
  EXPECT_TRUE(claims::left_out(with_floor(), "stress_error").empty());
}

}  // namespace mpmvv::samples_test
