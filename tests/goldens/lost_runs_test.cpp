#include "goldens/lost_runs.hpp"

#include <gtest/gtest.h>

namespace mpmvv::goldens::lost_runs_test {

using records::Point;
using records::Status;

LostRuns lost_of(const std::vector<Point>& all, double level = support::not_measured) {
  std::vector<const Point*> points;
  for (const Point& point : all) points.push_back(&point);
  return lost_runs(points, level);
}

TEST(LostRuns, OfRunsThatAreOkThereIsNothingToSay) {
  EXPECT_EQ(lost_of({{8, Status::ok, "", {}}}).text, "");
  EXPECT_EQ(lost_of({}).text, "");
}

TEST(LostRuns, OneSaysWhy) {
  const LostRuns failed = lost_of({{8, Status::ok, "", {}}, {16, Status::failed, "no mesh", {}}});
  EXPECT_EQ(failed.text, "the run at 16 failed: no mesh");
  EXPECT_EQ(failed.cause, "no mesh");
  EXPECT_EQ(lost_of({{0.4, Status::unstable, "energy", {}}}).text, "the run at 0.4 is unstable: energy");
  EXPECT_EQ(lost_of({{8, Status::failed, "", {}}}).text, "the run at 8 failed");
}

TEST(LostRuns, OfSeveralTheNamedOneOrTheLastSaysWhy) {
  const std::vector<Point> points{{8, Status::unstable, "energy", {}},
                                  {16, Status::failed, "no mesh", {}},
                                  {32, Status::ok, "", {}},
                                  {64, Status::unstable, "left the grid", {}}};
  EXPECT_EQ(lost_of(points).text, "the runs at 8 and 64 are unstable, the run at 16 failed; at 64: left the grid");
  EXPECT_EQ(lost_of(points, 16 * (1 + 1e-15)).text,
            "the runs at 8 and 64 are unstable, the run at 16 failed; at 16: no mesh");
  EXPECT_EQ(lost_of(points, 32).cause, "left the grid") << "that one is ok";
}

}  // namespace mpmvv::goldens::lost_runs_test
