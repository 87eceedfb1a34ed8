#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "reports/alarm_counts.hpp"
#include "tests/mutation/tests/samples.hpp"

namespace mpmvv::mutation::alarms_test {

TEST(Alarms, AreRunsInWhichAGoldenDoesNotPassOrNoneIsJudged) {
  const samples::OwnFolder folder;
  std::ofstream(folder / "log") << "digest = 'd1'\ngate = 'g1'\n"
                                   "3\tg++ -O2\t7\t0.1\t625\t0\t0\tgate: 625 pass, 0 fail, 0 inconclusive\n"
                                   "2\tclang++\t8\t0.2\t0\t0\t0\tno program\n"
                                   "1\tg++ -O2\t9\t0.3\t620\t5\t0\tfail a; fail b\n"
                                   "5\tg++ -O2\t9\t0.4\t624\t0\t1\tinconclusive c\n";
  const std::string script = std::string(MPMVV_SOURCE_DIR) + "/tests/mutation/alarms", log = folder / "log";
  const std::string counting = "log='" + log + "'; eval \"$(sed -n '/^count_by_build()/,/^}/p' '" + script +
                               "')\"; head -n 2 \"$log\"; count_by_build";
  std::ofstream(folder / "count") << counting;
  ASSERT_EQ(std::system(("bash '" + (folder / "count").string() + "' > '" + log + ".toml'").c_str()), 0);
  const auto builds = reports::read_alarms(log + ".toml").builds;
  ASSERT_EQ(builds.size(), 2U);
  EXPECT_EQ(builds[0].build, "clang++");
  EXPECT_EQ(builds[0].runs, 1);
  EXPECT_EQ(builds[0].judged, 0);
  EXPECT_EQ(builds[0].alarms, 1);
  EXPECT_EQ(builds[1].build, "g++ -O2");
  EXPECT_EQ(builds[1].runs, 3);
  EXPECT_EQ(builds[1].judged, 1875);
  EXPECT_EQ(builds[1].alarms, 2);
}

}  // namespace mpmvv::mutation::alarms_test
