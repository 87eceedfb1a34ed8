#include "reports/alarm_log.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "studies/support/error.hpp"

namespace mpmvv::reports::alarm_log_test {

using testing::HasSubstr;

class MutantFiles : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("mpmvv_alarms_" + std::to_string(getpid()));
};

TEST_F(MutantFiles, RunsWithoutAMistakeAreRead) {
  EXPECT_TRUE(read_alarms(folder_ / "alarms.toml").runs.empty());
  std::ofstream(folder_ / "alarms.toml")
      << "digest = 'd1'\n[[run]]\nnumber = 3\nbuild = 'g++ -O2'\nshuffle = 7\ngrid_offset = 0.37\npass = 579\n"
         "fail = 1\ninconclusive = 0\ntold = '''\nfail a: order of 'b''''\n";
  const AlarmLog log = read_alarms(folder_ / "alarms.toml");
  EXPECT_EQ(log.digest, "d1");
  ASSERT_EQ(log.runs.size(), 1U);
  EXPECT_EQ(log.runs[0].build, "g++ -O2");
  EXPECT_EQ(log.runs[0].pass, 579);
  EXPECT_TRUE(log.runs[0].is_alarm());
  std::ofstream(folder_ / "alarms.toml")
      << "digest = 'd1'\n[[run]]\nbuild = 'g++'\nshuffle = 1\ngrid_offset = 0\npass = -1\n";
  try {
    read_alarms(folder_ / "alarms.toml");
    ADD_FAILURE();
  } catch (const support::UsageError& e) {
    EXPECT_THAT(e.what(), HasSubstr("alarms.toml:6 (a count)"));
  }
}

}  // namespace mpmvv::reports::alarm_log_test
