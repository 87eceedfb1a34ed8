#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "solver/mpm.hpp"
#include "studies/problems/problem.hpp"
#include "studies/runs/blow_up.hpp"
#include "studies/runs/prepared_case.hpp"
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

/// Walls put energy in, also where it would be too much otherwise; a problem that could have walls does not.
TEST(BlowUp, HasABoundOfTheEnergyUnlessTheCaseHasWalls) {
  const auto with = [](const char* boundary) {
    return run({{"problem", "stretch-1d", ""},
                {"integrator", "usl", ""},
                {"boundary", boundary, ""},
                {"blowup_energy", "0.5", ""}});
  };
  EXPECT_EQ(with("wall").status, Status::ok) << with("wall").reason;
  EXPECT_NE(with("free").reason.find("energy "), std::string::npos) << with("free").reason;
}

/// Whatever the units: the bar is as in another test, but slower.
TEST(BlowUp, HasABoundOfSmallEnergies) {
  const records::Record slow = run({{"param.youngs_modulus", "1e-12", ""}, {"blowup_energy", "1e-4", ""}});
  EXPECT_NE(slow.reason.find("energy "), std::string::npos) << slow.reason;
  EXPECT_GT(slow.energy.initial_total, 0);
}

/// No problem starts with an energy that could be taken for round-off, or with round-off that could be taken for one.
TEST(BlowUp, TellsRestFromMotion) {
  int resting = 0;
  for (const problems::Problem& problem : problems::problems()) {
    if (!problem.has_solution(problems::complete_parameters(problem, {}))) continue;
    const std::string cells = problem.is_one_particle ? "1" : "8", ppc = problem.is_one_particle ? "1" : "2";
    const bool is_curved = problem.is_curved(problems::complete_parameters(problem, {}));
    const cases::Case c =
        settings::make_case(std::vector<settings::Setting>{{"problem", problem.name, ""},
                                                           {"cells", cells, ""},
                                                           {"ppc", ppc, ""},
                                                           {"cfl", "0.1", ""},
                                                           {"fill", is_curved ? "conforming" : "lattice", ""}});
    const auto energy_in = [&]<int D>(problems::SetupFunction<D>) {
      auto prepared = prepare_case<D>(c, problem, 1);
      const double rest = rest_energy(c, prepared.setup);
      const solver::Mpm<D> mpm(std::move(prepared.scene));
      return (mpm.kinetic_energy() + mpm.strain_energy()) / rest;
    };
    const double energy = std::visit(energy_in, problem.setup);
    EXPECT_TRUE(std::abs(energy) < 0.1 || energy > 100) << problem.name << ": " << energy;
    if (energy < 1) ++resting;
  }
  EXPECT_GT(resting, 3);
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
