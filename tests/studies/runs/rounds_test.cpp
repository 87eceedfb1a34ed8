#include "studies/runs/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace mpmvv::runs::rounds_test {

cases::Case repeated(const std::string& name, int repeat) {
  cases::Case c;
  c.problem.name = name;
  c.measure.repeat = repeat;
  return c;
}

TEST(Rounds, RunEachCaseOnceAndMeasureSoundOnesInTurns) {
  const std::vector<double> costs{20, 90, 70, 30, 40};
  std::string calls;
  std::size_t measured = 0;
  const auto records = run_in_rounds(
      {repeated("a", 3), repeated("b", 4), repeated("c", 4)},
      [&](const cases::Case& c) {
        calls += c.problem.name;
        records::Record r;
        r.the_case = c;
        r.particles = 1000, r.steps = 100, r.ns_per_particle_step = 50;
        r.status = c.problem.name == "c" ? records::Status::unstable : records::Status::ok;
        return r;
      },
      [&](const cases::Case& c) {
        calls += "+" + c.problem.name;
        records::Record r;
        r.ns_per_particle_step = costs[measured++];
        return r;
      });
  EXPECT_EQ(calls, "abc+a+b+a+b+b");
  EXPECT_EQ(records[0].ns_per_particle_step, 50);  // of 50, 20 and 70
  EXPECT_EQ(records[1].ns_per_particle_step, 45);  // of 50, 90, 30 and 40
  EXPECT_DOUBLE_EQ(records[1].cost.step_seconds, 45e-9 * 1000 * 100);
  EXPECT_DOUBLE_EQ(records[1].cost.spread, 60. / 45);
  EXPECT_EQ(records[2].ns_per_particle_step, 50);
  EXPECT_TRUE(std::isnan(records[2].cost.step_seconds));
}

TEST(Rounds, ARepetitionThatIsNotSoundReplacesTheRun) {
  int repetitions = 0;
  const auto records = run_in_rounds(
      {repeated("a", 4), repeated("b", 3)},
      [](const cases::Case& c) {
        records::Record r;
        r.the_case = c;
        r.particles = 1000, r.steps = 100, r.ns_per_particle_step = 50;
        return r;
      },
      [&](const cases::Case& c) {
        records::Record r;
        r.the_case = c;
        r.ns_per_particle_step = 40;
        if (c.problem.name == "a" && ++repetitions == 2) r.status = records::Status::failed, r.reason = "no licence";
        return r;
      });
  EXPECT_EQ(repetitions, 2) << "and is the last";
  EXPECT_EQ(records[0].status, records::Status::failed);
  EXPECT_EQ(records[0].reason, "no licence");
  EXPECT_TRUE(std::isnan(records[0].cost.step_seconds));
  EXPECT_EQ(records[1].status, records::Status::ok);
  EXPECT_EQ(records[1].ns_per_particle_step, 40);
}

}  // namespace mpmvv::runs::rounds_test
