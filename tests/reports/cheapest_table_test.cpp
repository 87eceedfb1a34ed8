#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/chart.hpp"
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

/// A series that reaches an error of 0.01 in a time with a spread (the range over the median).
records::Series timed(const std::string& name, double seconds, double spread) {
  records::Series series{name, {}, {}, std::nullopt};
  series.points.push_back(
      {1, records::Status::ok, "", {{"l2", 0.01}, {"step_seconds", seconds}, {"step_seconds_spread", spread}}});
  return series;
}

/// The best one's range ends at 11 s. That of 12 s begins there by a spread of 1/6.
TEST(CheapestTable, SeriesWhoseRangesOverlapAreAsCheap) {
  records::StudyResult study = measured({});
  study.series = {timed("best", 10, 0.2), timed("apart", 12, 0.16), timed("reaches", 12, 0.17), timed("wide", 20, 1),
                  timed("dear", 30, 0)};
  EXPECT_THAT(cheapest_table(study).groups.at(0).rows.at(0),
              testing::ElementsAre("1e-02", "best", "10", "reaches, wide", "apart", "12", "1.20", "0 of 5"));
  study.series.erase(study.series.begin() + 1), study.series.pop_back();
  EXPECT_THAT(cheapest_table(study).groups.at(0).rows.at(0),
              testing::ElementsAre("1e-02", "best", "10", "reaches, wide", "–", "–", "–", "0 of 3"));
}

TEST(CheapestTable, SeriesTimedTogetherAreComparedRoundByRound) {
  records::StudyResult study = measured({});
  study.series = {timed("best", 10, 1), timed("always dearer", 11, 1), timed("dearer by chance", 11, 1)};
  for (records::Series& series : study.series) series.points[0].rounds = {{1, 2, 3}, "one"};
  study.series[2].points[0].rounds.costs[0] *= 1.2;
  EXPECT_THAT(cheapest_table(study).groups.at(0).rows.at(0),
              testing::ElementsAre("1e-02", "best", "10", "dearer by chance", "always dearer", "11", "1.10", "0 of 3"));
}

TEST(CheapestTable, SaysWhoseTimeIsThatOfTheWholeProcess) {
  records::StudyResult study = measured({});
  study.series = {timed("ours", 10, 0), timed("theirs", 12, 0)};
  EXPECT_EQ(cheapest_table(study).note, "");
  study.series[1].code = records::OtherCode{"my-code", "1.3", "", ""};
  const char* note = "Of other codes the time is that of the whole process, start included, not of the steps: theirs.";
  EXPECT_EQ(cheapest_table(study).note, note);
  EXPECT_THAT(work_chart(study, study.figures[0]).notes, testing::Contains(note));
}

TEST(CheapestTable, AnInfiniteErrorHasNoDecades) {
  EXPECT_TRUE(claims::work_points(measured({INFINITY}).series[0], "l2").empty());
  EXPECT_TRUE(cheapest_table(measured({INFINITY})).empty());
}

}  // namespace mpmvv::reports::cheapest_table_test
