#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "studies/problems/setup.hpp"
#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::runs::walls_test {

using records::Record;
using settings::make_case;

using Pairs = std::vector<std::pair<std::string, std::string>>;

std::vector<settings::Setting> stretch(const std::string& problem, const Pairs& more) {
  std::vector<settings::Setting> settings;
  for (const auto& [key, value] : Pairs{{"problem", problem}, {"basis", "cpdi"}, {"cells", "4"}, {"ppc", "2"}})
    settings.push_back({key, value, "a.toml:1"});
  for (const auto& [key, value] : more) settings.push_back({key, value, "a.toml:9"});
  if (std::none_of(more.begin(), more.end(), [](const auto& pair) { return pair.first == "cfl"; }))
    settings.push_back({"cfl", "0.2", "a.toml:1"});
  return settings;
}

Record run(const std::string& problem, Pairs more) {
  more.emplace_back("velocity_error", "true");
  return run_case(make_case(stretch(problem, more)), 1);
}

TEST(Stretch, WallsHaveTheDepthAndGradientAskedFor) {
  const cases::Case plain = make_case(stretch("stretch", {}));
  EXPECT_EQ(plain.scheme.boundary, "xmin=wall,xmax=wall,ymin=free,ymax=free");
  EXPECT_EQ(plain.scheme.wall_depth, 1);
  EXPECT_EQ(plain.scheme.wall_gradient, cases::WallGradient::given);
  EXPECT_EQ(plain.problem.end_time, 80);
  const cases::Case other = make_case(stretch("stretch", {{"wall_depth", "2.5"}, {"wall_gradient", "estimated"}}));
  EXPECT_EQ(other.scheme.wall_depth, 2.5);
  EXPECT_EQ(other.scheme.wall_gradient, cases::WallGradient::estimated);
  const cases::Case bar = make_case(stretch("bar", {}));
  EXPECT_EQ(bar.scheme.wall_depth, 0);
  EXPECT_EQ(bar.scheme.wall_gradient, cases::WallGradient::none);
}

/// The walls' work is many times the energy at the start, and no sign of a run that has blown up.
TEST(Stretch, IsTheSameInEveryDimension) {
  const Pairs update{{"velocity_update", "fmpm"}, {"order", "2"}, {"cells", "1"}};
  const Record line = run("stretch-1d", update), plane = run("stretch", update), space = run("stretch-3d", update);
  EXPECT_EQ(line.particles, 10);
  EXPECT_EQ(space.particles, 40);
  for (const Record& r : {line, plane, space}) {
    EXPECT_EQ(r.status, records::Status::ok) << r.reason;
    EXPECT_NEAR(r.error.velocity, line.error.velocity, 1e-6 * line.error.velocity);
    EXPECT_NEAR(r.error.l2, line.error.l2, 1e-6 * line.error.l2);
  }
}

/// At this offset the sides' particles lie on the faces of the grid and come back on the other side, 4 m away.
TEST(Stretch, ErrorsOfPeriodicSidesAreTakenByTheirOwnPeriod) {
  const Pairs sides{{"boundary", "xmin=wall,xmax=wall,ymin=periodic,ymax=periodic"}, {"grid_offset", "0.25"}};
  const Record record = run("stretch", sides), plain = run("stretch", {});
  EXPECT_EQ(record.status, records::Status::ok) << record.reason;
  EXPECT_NEAR(record.error.l2, plain.error.l2, 1e-6 * plain.error.l2);
}

/// At any time a wall is where the end of the square is, moves as it does, and says how the velocity changes there.
TEST(Swing, WallsMoveAsTheSolutionDoes) {
  const problems::Parameters parameters =
      problems::complete_parameters(problems::find_problem("swing", "the test"), {{"amplitude", -0.1}});
  const auto setup =
      std::get<problems::SetupFunction<2>>(problems::find_problem("swing", "the test").setup)(parameters);
  const solver::Vec<2> step = 1e-6 * solver::Vec<2>::Unit(0);
  for (const double t : {0.0, 0.0013, 0.0051, 0.0098})
    for (const int face : {0, 1}) {
      const solver::Vec<2> X(face, 0.3);
      const auto& wall = *setup.walls[static_cast<std::size_t>(face)];
      const auto& solution = *setup.solution;
      EXPECT_NEAR(wall.position(t), X[0] + solution.u(X, t)[0], 1e-15);
      EXPECT_NEAR(wall.velocity(t), solution.v(X, t)[0], 1e-12);
      EXPECT_NEAR(wall.gradient(t), (solution.v(X + step, t) - solution.v(X - step, t))[0] / 2e-6, 1e-6);
    }
}

/// In per cent of the speed of the ends, so that a bar that the walls have lost errs by about 100.
TEST(Stretch, VelocityErrorsAreThoseOfABarHeldOrNot) {
  const double held = run("stretch-1d", {{"velocity_update", "fmpm"}, {"order", "2"}}).error.velocity;
  EXPECT_GT(held, 0);
  EXPECT_LT(held, 0.1);
  const double lost = run("stretch-1d", {{"boundary", "free"}, {"blowup_error", "100"}}).error.velocity;
  EXPECT_GT(lost, 30);
  EXPECT_LT(lost, 300);
  EXPECT_TRUE(std::isnan(run_case(make_case(stretch("stretch-1d", {})), 1).error.velocity));
}

TEST(Stretch, AnEstimatedGradientServesWhereNoneIsGiven) {
  const auto error = [](const char* gradient) {
    return run("stretch-1d", {{"velocity_update", "fmpm"}, {"order", "2"}, {"wall_gradient", gradient}}).error.velocity;
  };
  EXPECT_LT(error("given"), error("estimated"));
  EXPECT_LT(error("estimated"), error("zero"));
}

/// One line that says what is wrong, where, and what would be right.
TEST(Walls, WhatTheyDoNotGoWith) {
  struct Wrong {
    std::string problem;
    Pairs settings;
    std::string message;
  };
  for (const auto& [problem, settings, message] : {
           Wrong{"bar",
                 {{"boundary", "wall"}},
                 "boundary 'wall' on face xmin of problem 'bar', which has no moving wall"},
           Wrong{"stretch", {{"boundary", "wall"}}, "on face ymin of problem 'stretch'"},
           Wrong{"bar", {{"wall_depth", "1"}}, "wall_depth in a.toml:9 has no meaning for boundary 'periodic'"},
           Wrong{"bar", {{"wall_gradient", "zero"}}, "wall_gradient in a.toml:9 has no meaning"},
           Wrong{"stretch", {{"wall_depth", "-1"}}, "wall_depth = -1 in a.toml:9 (a number >= 0)"},
           Wrong{"stretch", {{"wall_gradient", "none"}}, "(known: zero, given, estimated)"},
           Wrong{"stretch", {{"integrator", "cd"}}, "boundary 'wall' with integrator 'cd'"},
           Wrong{"stretch", {{"integrator", "rk4"}}, "usf, usl, usavg, usl+, usavg+"},
           Wrong{"stretch",
                 {{"wall_acceleration", "difference"}, {"boundary", "xmin=wall,xmax=wall,ymin=symmetry,ymax=symmetry"}},
                 "wall_acceleration 'difference' with boundary 'wall'"},
           Wrong{"stretch", {{"mass", "consistent"}}, "use fmpm"},
           Wrong{"bar", {{"velocity_error", "true"}}, "problem 'bar' has no speed"},
       }) {
    try {
      make_case(stretch(problem, settings));
      ADD_FAILURE() << message;
    } catch (const support::UsageError& e) {
      EXPECT_NE(std::string(e.what()).find(message), std::string::npos) << e.what();
    }
  }
  EXPECT_NO_THROW(make_case(stretch("stretch", {{"velocity_update", "fmpm"}, {"mass", "consistent"}})));
}

}  // namespace mpmvv::runs::walls_test
