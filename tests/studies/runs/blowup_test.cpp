#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::runs::blowup_test {

using records::Status;

records::Record run(const std::vector<settings::Setting>& more) {
  std::vector<settings::Setting> settings{{"problem", "bar", ""}, {"basis", "bspline2", ""}, {"integrator", "cd", ""},
                                          {"cells", "8", ""},     {"ppc", "2", ""},          {"cfl", "0.2", ""},
                                          {"steps", "100", ""}};
  settings.insert(settings.end(), more.begin(), more.end());
  return run_case(settings::make_case(settings), 1);
}

/// However long a run is and whatever else is measured of it, it ends where it has left its bounds.
TEST(BlowUp, IsLookedForOnTheWayAndAtTheEnd) {
  for (const char* key : {"blowup_error", "blowup_energy"})
    for (const char* every_step : {"false", "true"}) {
      const records::Record record = run({{key, "1e-4", ""}, {"every_step", every_step, ""}});
      EXPECT_EQ(record.status, Status::unstable);
      EXPECT_EQ(record.steps, 32);
      EXPECT_NE(record.reason.find("at step 32 of 100"), std::string::npos) << record.reason;
      EXPECT_EQ(run({{key, "1e-4", ""}, {"every_step", every_step, ""}, {"steps", "20", ""}}).status, Status::unstable);
    }
  EXPECT_EQ(run({}).status, Status::ok);
}

/// The largest error is 0.091, 0.124, 0.098 and 0.101 amplitudes at steps 32, 64, 96 and 100.
TEST(BlowUp, IsOneAlsoWhenTheRunComesBack) {
  EXPECT_EQ(run({{"blowup_error", "0.13", ""}}).status, Status::ok);
  const records::Record record = run({{"blowup_error", "0.112", ""}});
  EXPECT_EQ(record.status, Status::unstable);
  EXPECT_EQ(record.steps, 64);
}

/// The last particle of a bar that nothing holds moves on by 0.2 cells a step, and is a cell out after some of them.
TEST(BlowUp, IsOneAlsoInTheStateAfterTheLastStep) {
  const auto after = [](int steps) {
    return run({{"problem", "translation", ""},
                {"integrator", "usl", ""},
                {"boundary", "free", ""},
                {"steps", std::to_string(steps), ""}});
  };
  const records::Record last = after(25);
  EXPECT_EQ(last.status, Status::unstable);
  EXPECT_EQ(last.steps, 25);
  EXPECT_EQ(last.reason, "a particle left the domain at step 25 of 25");
  EXPECT_TRUE(std::isnan(last.error.linf));
  EXPECT_EQ(after(26).reason, "a particle left the domain at step 26 of 26");
  EXPECT_EQ(after(24).status, Status::ok);
}

}  // namespace mpmvv::runs::blowup_test
