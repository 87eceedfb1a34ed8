#include <gmock/gmock.h>

#include <cmath>

#include "studies/codes/external_run.hpp"
#include "tests/studies/codes/mover.hpp"

/// Codes that choose their time step themselves.
namespace mpmvv::codes::own_step_test {

using records::Record;
using records::Status;

class OwnStep : public testing::Test {
 protected:
  OwnStep() { mover_.adapter(Mover::text + std::string("[step]\nrule = \"own\"\n")); }

  /// A run whose output begins with these lines of comments. One that is repeated takes a time beside which what else
  /// the machine does counts little.
  Record run(const std::string& comments, int repeat = 0) const {
    const std::string pause = repeat > 0 ? "sleep 0.1\n" : "";
    mover_.script(pause + "echo '" + comments + "id,x,y,m' > particles.csv\n" + after_its_head());
    auto settings = Mover::settings();
    if (repeat > 0) settings.push_back({"repeat", std::to_string(repeat), "test"});
    const Codes codes{{"mover", mover_.code()}};
    return time_in_rounds({run_untimed(settings::make_case(settings), codes)}, codes).at(0);
  }

  const Mover mover_;

 private:
  static std::string after_its_head() {
    const std::string moving = Mover::moving;
    return moving.substr(moving.find("awk"));
  }
};

TEST_F(OwnStep, ItsNumberIsWhatTheOutputSays) {
  const Record record = run("# step: 7\n");
  EXPECT_EQ(record.status, Status::ok) << record.reason;
  EXPECT_EQ(record.steps, 7);
  EXPECT_TRUE(std::isnan(record.cfl));
  EXPECT_DOUBLE_EQ(record.ns_per_particle_step, 1e9 * record.wall_seconds / (64 * 7));
}

TEST_F(OwnStep, ItsNumberIsUnknownOtherwise) {
  const Record record = run("");
  EXPECT_EQ(record.status, Status::ok) << record.reason;
  EXPECT_EQ(record.steps, 0);
  EXPECT_TRUE(std::isnan(record.cfl));
  EXPECT_TRUE(std::isnan(record.ns_per_particle_step));
  EXPECT_GT(record.wall_seconds, 0);
}

/// The case's own are 16 steps of 1/32 of the end time.
TEST_F(OwnStep, MayBeSaidInTheOutput) {
  EXPECT_EQ(run("# dt = 0.7\n# cfl = 0.9\n# steps = 5\n").status, Status::ok) << run("# dt = 0.7\n").reason;
  mover_.adapter(Mover::text);
  EXPECT_EQ(run("# dt = 0.7\n").status, Status::failed);
}

TEST_F(OwnStep, ItsRunsHaveACostWithoutTheirNumberOfSteps) {
  const Record record = run("", 3);
  EXPECT_EQ(record.steps, 0);
  EXPECT_TRUE(std::isnan(record.ns_per_particle_step));
  EXPECT_GT(record.cost.step_seconds, record.wall_seconds / 10);
  EXPECT_LT(record.cost.step_seconds, record.wall_seconds * 10);
  EXPECT_GE(record.cost.spread, 0);
}

}  // namespace mpmvv::codes::own_step_test
