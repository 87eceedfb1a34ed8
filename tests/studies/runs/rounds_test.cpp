#include "studies/runs/rounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace mpmvv::runs::rounds_test {

using records::Record;
using records::Status;
using testing::ElementsAre;

Record first_run(const std::string& name, int repeat, Status status = Status::ok) {
  Record r;
  r.the_case.problem.name = name;
  r.the_case.measure.repeat = repeat;
  r.particles = 1000, r.steps = 100, r.ns_per_particle_step = 50;
  r.status = status;
  return r;
}

TEST(Rounds, MeasureSoundCasesInTurns) {
  const std::vector<double> costs{20, 30, 60, 40, 90, 30, 30};
  std::string calls;
  std::size_t measured = 0;
  const auto records = time_in_rounds({first_run("a", 3), first_run("b", 4), first_run("c", 4, Status::unstable)},
                                      [&](const cases::Case& c) {
                                        calls += c.problem.name;
                                        Record r;
                                        r.ns_per_particle_step = costs[measured++];
                                        return r;
                                      });
  EXPECT_EQ(calls, "abbaabb") << "every other round in reversed order";
  EXPECT_THAT(records[0].cost.rounds.costs, ElementsAre(20, 40, 90));
  EXPECT_THAT(records[1].cost.rounds.costs, ElementsAre(30, 60, 30, 30));
  EXPECT_NEAR(records[0].ns_per_particle_step, std::cbrt(20. * 40 * 90), 1e-12);
  const double mean = std::pow(30. * 60 * 30 * 30, 0.25);
  EXPECT_NEAR(records[1].ns_per_particle_step, mean, 1e-12);
  EXPECT_NEAR(records[1].cost.step_seconds, 1e-9 * mean * 1000 * 100, 1e-15);
  EXPECT_NEAR(records[1].cost.spread, 30 / mean, 1e-12);
  EXPECT_EQ(records[0].cost.rounds.session, records[1].cost.rounds.session);
  EXPECT_FALSE(records[0].cost.rounds.session.empty());
  EXPECT_EQ(records[2].ns_per_particle_step, 50);
  EXPECT_EQ(records[2].cost.rounds, fits::Rounds{});
  EXPECT_TRUE(std::isnan(records[2].cost.step_seconds));
}

TEST(Rounds, ARepetitionThatIsNotSoundReplacesTheRun) {
  int repetitions = 0;
  const auto records = time_in_rounds({first_run("a", 4), first_run("b", 3)}, [&](const cases::Case& c) {
    Record r;
    r.the_case = c;
    r.ns_per_particle_step = 40;
    if (c.problem.name == "a" && ++repetitions == 2) r.status = Status::failed, r.reason = "no licence";
    return r;
  });
  EXPECT_EQ(repetitions, 2) << "and is the last";
  EXPECT_EQ(records[0].status, Status::failed);
  EXPECT_EQ(records[0].reason, "no licence");
  EXPECT_TRUE(std::isnan(records[0].cost.step_seconds));
  EXPECT_EQ(records[0].cost.rounds, fits::Rounds{});
  EXPECT_EQ(records[1].status, Status::ok);
  EXPECT_NEAR(records[1].ns_per_particle_step, 40, 1e-12);
}

TEST(Rounds, OfEachCallAreASessionOfTheirOwn) {
  const auto session = [] {
    const auto run = [](const cases::Case&) { return first_run("a", 3); };
    return time_in_rounds({first_run("a", 3)}, run).front().cost.rounds.session;
  };
  EXPECT_NE(session(), session());
}

}  // namespace mpmvv::runs::rounds_test
