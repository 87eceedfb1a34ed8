#include "studies/settings/scales.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings::scales_test {

using Pairs = std::vector<std::pair<std::string, std::string>>;

cases::Case case_of(const std::string& problem, const Pairs& more) {
  const bool one = problem == "one-particle";
  std::vector<Setting> settings{{"problem", problem, ""},
                                {"basis", one ? "linear" : "bspline2", ""},
                                {"integrator", "usl", ""},
                                {"cells", one ? "1" : "4", ""},
                                {"ppc", one ? "1" : "2", ""}};
  for (const auto& [key, value] : more) settings.push_back({key, value, "a.toml:9"});
  return make_case(settings);
}

void expect_sizes(const cases::Case& c, const std::string& what) {
  const problems::Problem& problem = problems::find_problem(c.problem.name, "");
  const double speed = problem.wave_speed(c.problem.parameters);
  const double cell_masses = std::visit([&](auto make) { return make(c.problem.parameters).density; }, problem.setup) *
                             problems::extent(c).cells_of_body;
  for (const double size : {speed, cell_masses, c.problem.end_time, c.resolution.dt, speed * c.resolution.dt})
    EXPECT_TRUE(std::isnormal(size) && size > 0) << what << ": " << size;
  EXPECT_GE(c.resolution.steps, 1) << what;
}

/// The numbers at the ends of what a double takes, one at a time: refused, or all that follows is a number.
TEST(Scales, NoExtremeNumberOfAnyProblemRunsIntoNonsense) {
  for (const problems::Problem& problem : problems::problems()) {
    std::vector<std::string> keys{"end_time", "cfl", "dt"};
    for (const problems::Parameter& parameter : problem.parameters) keys.push_back("param." + parameter.name);
    for (const std::string& key : keys)
      for (const char* value : {"5e-324", "1e-308", "1e-300", "1e-149", "1e-75", "1e75", "1e149", "1e300", "1e308"}) {
        Pairs settings{{key, value}};
        if (key != "cfl" && key != "dt") settings.emplace_back("cfl", "0.2");
        if (key == "dt") settings.emplace_back("end_time", value);
        const std::string what = problem.name + " with " + key + " = " + value;
        try {
          expect_sizes(case_of(problem.name, settings), what);
        } catch (const support::UsageError& e) {
          EXPECT_THAT(e.what(), testing::Not(testing::ContainsRegex("\\b(inf|nan)\\b"))) << what;
        }
      }
  }
}

TEST(Scales, WhatFollowsIsNamedWithTheNumberItComesFrom) {
  const auto complaint = [](const std::string& problem, const Pairs& settings) -> std::string {
    try {
      case_of(problem, settings);
    } catch (const support::UsageError& e) {
      return e.what();
    }
    return "";
  };
  const auto at_cfl = [&](const std::string& problem, const std::string& key, const std::string& value) {
    return complaint(problem, {{"cfl", "0.2"}, {key, value}});
  };
  EXPECT_EQ(at_cfl("bar", "param.density", "1e-308"),
            "param.density = 1e-308 in a.toml:9 (a number from 1e-150 to 1e+150 in size)");
  EXPECT_EQ(at_cfl("ring", "param.outer_radius", "1e149"),
            "the volume of problem 'ring' is 3.14e+298 m3 with param.outer_radius = 1e149 in a.toml:9 (a number from "
            "1e-150 to 1e+150)");
  using testing::HasSubstr;
  EXPECT_THAT(at_cfl("impact", "param.velocity", "1e140"), HasSubstr("the kinetic energy of problem 'impact' is 3"));
  EXPECT_THAT(at_cfl("vortex", "param.period", "1e-149"), HasSubstr("the kinetic energy of problem 'vortex' is "));
  EXPECT_THAT(complaint("bar", {{"cfl", "0.2"}, {"param.youngs_modulus", "1e140"}, {"param.density", "1e-140"}}),
              HasSubstr("the body force of problem 'bar' is infinite m/s2"));
  EXPECT_THAT(complaint("stretch", {{"dt", "1e40"}, {"end_time", "1e40"}}), HasSubstr("cells of 1 m (at most 1e8)"));
  EXPECT_THAT(complaint("bar", {{"cfl", "1e-140"}}),
              HasSubstr("until 0.01 s given in a.toml:9 (at most 1e12 of them)"));
  EXPECT_THAT(complaint("bar", {{"dt", "1e149"}, {"end_time", "1e149"}}), HasSubstr("the CFL number of problem 'bar'"));
}

}  // namespace mpmvv::settings::scales_test
