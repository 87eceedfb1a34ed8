#include "studies/settings/validate.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings::validate_test {

using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

cases::Case bar_case() {
  const std::vector<Setting> settings{
      {"problem", "bar", ""}, {"cells", "16", ""}, {"ppc", "2", ""}, {"cfl", "0.1", ""}};
  return make_case(settings);
}

void check(const cases::Case& c) {
  validate(c, problems::find_problem(c.problem.name, ""));
}

TEST(Validate, EveryObjectionSaysItWithTheCasesOwnWords) {
  const cases::Case c = bar_case();
  const std::vector<std::string> all = objections(c, problems::find_problem("bar", ""));
  EXPECT_GT(all.size(), 20U);
  for (const std::string& text : all) EXPECT_THAT(text, Not(HasSubstr("{"))) << text;
  for (const char* text : {"basis 'linear' has no ghost nodes, so boundary 'periodic' has nothing to act on",
                           "with integrator 'usl' (flip with position 'first-order'"})
    EXPECT_THAT(all, testing::Contains(HasSubstr(text)));
}

TEST(Validate, ThrowsTheFirstThatIsBroken) {
  EXPECT_NO_THROW(check(bar_case()));
  cases::Case c = bar_case();
  c.scheme.fill = cases::Fill::conforming;
  EXPECT_THAT([&] { check(c); }, ThrowsMessage<support::UsageError>(HasSubstr("which a lattice fills")));
  c.scheme.integrator = "rk4";
  c.scheme.deformation = cases::Deformation::exponential;
  EXPECT_THAT([&] { check(c); },
              ThrowsMessage<support::UsageError>(
                  "deformation 'exponential' with integrator 'rk4', whose stages are linear (use linear)"));
}

cases::Case case_of(std::vector<Setting> settings) {
  for (const auto& [key, value] : std::map<std::string, std::string>{{"cells", "16"}, {"ppc", "2"}, {"cfl", "0.1"}})
    settings.push_back({key, value, ""});
  return make_case(settings);
}

TEST(Validate, NamesTheFaceWithoutAWall) {
  cases::Case c = bar_case();
  c.scheme.boundary = "xmin=free,xmax=wall";
  EXPECT_THAT([&] { check(c); },
              ThrowsMessage<support::UsageError>("boundary 'wall' on face xmax of problem 'bar', which has no moving "
                                                 "wall there (faces with one: none)"));
  EXPECT_THAT(
      [] {
        case_of({{"problem", "swing", ""}, {"boundary", "wall", ""}});
      },
      ThrowsMessage<support::UsageError>(
          HasSubstr("on face ymin of problem 'swing', which has no moving wall there (faces with one: xmin, xmax)")));
}

/// The bar is 80 cells long, and longer at the end.
TEST(Validate, WallsLeaveNodesToTheMethod) {
  const auto with_depth = [](const char* depth, const char* boundary) {
    return [=] { case_of({{"problem", "stretch-1d", ""}, {"boundary", boundary, ""}, {"wall_depth", depth, ""}}); };
  };
  const auto refused = ThrowsMessage<support::UsageError>(HasSubstr("of each wall, 80 cells apart"));
  EXPECT_NO_THROW(with_depth("39", "wall")());
  EXPECT_THAT(with_depth("40", "wall"), refused);
  EXPECT_NO_THROW(with_depth("79", "xmin=wall,xmax=free")());
  EXPECT_THAT(with_depth("80", "xmin=wall,xmax=free"), refused);
}

/// Half a period of the swing: its walls are 16 cells apart at both ends of the run, and 11.2 between.
TEST(Validate, WallsLeaveNodesToTheMethodDuringTheWholeRun) {
  const auto with_depth = [](const char* depth) {
    return [=] { case_of({{"problem", "swing", ""}, {"param.amplitude", "0.15", ""}, {"wall_depth", depth, ""}}); };
  };
  EXPECT_NO_THROW(with_depth("5.5")());
  EXPECT_THAT(with_depth("5.61"), ThrowsMessage<support::UsageError>(HasSubstr("of each wall, 11.2 cells apart")));
}

TEST(Validate, AQuarterIsContinuedWhereItWasCut) {
  const auto quarter = [](const char* problem, const std::string& boundary) {
    return [=] { case_of({{"problem", problem, ""}, {"quarter", "true", ""}, {"boundary", boundary, ""}}); };
  };
  EXPECT_NO_THROW(quarter("ring", "xmin=symmetry,xmax=free,ymin=mirror,ymax=free")());
  for (const char* cut : {"free", "dirichlet"})
    EXPECT_THAT(quarter("ring", fmt::format("xmin=symmetry,xmax=free,ymin={},ymax=free", cut)),
                ThrowsMessage<support::UsageError>(HasSubstr("whose face ymin was cut (symmetry or mirror there)")));
  EXPECT_THAT(quarter("cube", "free"), ThrowsMessage<support::UsageError>(HasSubstr("whose face xmax was cut")));
  EXPECT_THAT(quarter("impact", "xmin=free,xmax=symmetry,ymin=free,ymax=free"),
              ThrowsMessage<support::UsageError>(HasSubstr("whose face ymax was cut")));
}

TEST(Validate, ErrorsAtEveryStepNeedASolution) {
  EXPECT_THAT(
      [] {
        case_of({{"problem", "impact", ""}, {"every_step", "true", ""}});
      },
      ThrowsMessage<support::UsageError>(HasSubstr("no exact displacement for every_step")));
}

}  // namespace mpmvv::settings::validate_test
