#include "reports/unstable_band.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reports/plot_elements.hpp"
#include "tests/reports/synthetic.hpp"

namespace mpmvv::reports::unstable_band_test {

/// The band is above the range that was asked for, and what is above that range is not drawn in it.
TEST(UnstableBand, HasNoValues) {
  auto study = synthetic::convergence();
  study.figures[0].y_min = 1e-6, study.figures[0].y_max = 1e-3;
  const auto chart = error_chart(study, study.figures[0]);
  EXPECT_NEAR(top_of_values(chart), 1e-3, 1e-12);
  EXPECT_FALSE(holds(chart, {.x = 16, .value = 1.01e-3, .drawn = 1.01e-3}));
  EXPECT_TRUE(holds(chart, {.x = 16, .value = 0.99e-3, .drawn = 0.99e-3}));
  const std::string elements = plot_elements(chart, 1), data = plot_data(chart);
  EXPECT_LT(elements.rfind("pt 7"), elements.find("1:2:3:4:5:6 with boxxyerror")) << "the band hides values";
  EXPECT_LT(elements.find("1:2:3:4:5:6 with boxxyerror"), elements.find("pt 2 ")) << "and the crosses are on it";
  EXPECT_THAT(data, testing::HasSubstr("# band of the unstable: x, y, from and to in x, from and to in y\n"));
}

/// Runs that the figure leaves out at its sides need no band, and are said to be left out.
TEST(UnstableBand, IsThereOnlyForRunsWithinTheAxes) {
  auto study = synthetic::convergence();
  const auto whole = error_chart(study, study.figures[0]);
  ASSERT_GT(whole.band, 0);
  std::erase_if(study.series, [](const records::Series& series) {
    return std::ranges::find(series.points, records::Status::unstable, &records::Point::status) == series.points.end();
  });
  double last = 0;
  for (const Curve& curve : whole.curves)
    for (const Dot& dot : curve.dots)
      if (dot.mark == Mark::unstable) last = std::max(last, dot.x);
  study.figures[0].series.clear();
  study.figures[0].x_min = 1.1 * last, study.figures[0].x_max = 1e4;
  const auto chart = error_chart(study, study.figures[0]);
  EXPECT_EQ(chart.band, 0);
  EXPECT_THAT(chart.notes, testing::Each(testing::Not(testing::HasSubstr("Crosses"))));
  EXPECT_THAT(chart.omissions, testing::Contains(testing::HasSubstr("(unstable, off the axes)")));
}

}  // namespace mpmvv::reports::unstable_band_test
