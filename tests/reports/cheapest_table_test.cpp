#include <gtest/gtest.h>

#include "reports/table.hpp"
#include "studies/claims/samples.hpp"
#include "studies/fits/work_precision.hpp"
#include "tests/reports/synthetic.hpp"

namespace mpmvv::reports::cheapest_table_test {

records::StudyResult measured(const std::vector<double>& errors) {
  records::StudyResult study = synthetic::convergence();
  study.figures[0].kind = records::Figure::Kind::work_precision;
  study.series = {{"s", {}, {}, std::nullopt}};
  for (const double error : errors)
    study.series[0].points.push_back({1, records::Status::ok, "", {{"l2", error}, {"step_seconds", 1 / error}}});
  return study;
}

TEST(CheapestTable, APowerOfTenThatNoneReachesHasNoRow) {
  EXPECT_TRUE(cheapest_table(measured({1e-3 * (1 + 1e-10)})).empty());
  EXPECT_EQ(cheapest_table(measured({2e-4, 2e-3})).groups.at(0).rows.size(), 1u);
}

TEST(CheapestTable, AnInfiniteErrorHasNoDecades) {
  EXPECT_TRUE(claims::work_points(measured({INFINITY}).series[0], "l2").empty());
  EXPECT_TRUE(cheapest_table(measured({INFINITY})).empty());
}

}  // namespace mpmvv::reports::cheapest_table_test
