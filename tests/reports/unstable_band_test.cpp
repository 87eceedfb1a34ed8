#include "reports/unstable_band.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace mpmvv::reports::unstable_band_test
