#include "reports/alarm_counts.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "studies/support/error.hpp"
#include "tests/own_folder.hpp"

namespace mpmvv::reports::alarm_counts_test {

using testing::HasSubstr;

class AlarmFiles : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ = own_folder("alarms");
};

TEST_F(AlarmFiles, HoldTheRunsOfEachBuild) {
  EXPECT_TRUE(read_alarms(folder_ / "alarms.toml").builds.empty());
  std::ofstream(folder_ / "alarms.toml")
      << "digest = 'd1'\ngate = 'g1'\n[[build]]\nname = 'g++ -O2'\nruns = 3\njudged = 1803\nalarms = 1\n";
  const AlarmCounts counts = read_alarms(folder_ / "alarms.toml");
  EXPECT_EQ(counts.digest, "d1");
  ASSERT_EQ(counts.builds.size(), 1U);
  EXPECT_EQ(counts.builds[0].build, "g++ -O2");
  EXPECT_EQ(counts.builds[0].runs, 3);
  EXPECT_EQ(counts.builds[0].judged, 1803);
  EXPECT_EQ(counts.builds[0].alarms, 1);
}

TEST_F(AlarmFiles, AreRefusedWithTheLineThatIsWrong) {
  std::ofstream(folder_ / "alarms.toml")
      << "digest = 'd1'\ngate = 'g1'\n[[build]]\nname = 'g++'\nruns = 3\njudged = -1\n";
  try {
    read_alarms(folder_ / "alarms.toml");
    ADD_FAILURE();
  } catch (const support::UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("alarms.toml:6 (a count)"));
  }
}

}  // namespace mpmvv::reports::alarm_counts_test
