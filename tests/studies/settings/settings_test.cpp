#include "studies/settings/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/plan/study.hpp"
#include "studies/settings/boundaries.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings::settings_test {

using support::UsageError;

std::vector<Setting> bar_settings(std::initializer_list<std::pair<const char*, const char*>> more = {}) {
  std::vector<Setting> settings{{"problem", "bar", "a.toml:1"}, {"cells", "32", "a.toml:2"}, {"ppc", "4", "a.toml:3"}};
  for (const auto& [key, value] : more) settings.push_back({key, value, "a.toml:9"});
  return settings;
}

TEST(Settings, CflDividesTheEndTime) {
  const cases::Case c =
      make_case(bar_settings({{"cfl", "0.3"}}));  // C = 100, h = 1/32, T = 0.01: Δt <= 9.375e-5, 107 steps
  EXPECT_EQ(c.resolution.steps, 107);
  EXPECT_DOUBLE_EQ(c.resolution.dt, 0.01 / 107);
  EXPECT_EQ(make_case(bar_settings({{"cfl", "0.32"}})).resolution.steps, 100)
      << "a step that divides exactly is taken as it is";
}

/// Δt = T/ceil(T/Δt_max - 1e-9): rounded to the nearest, the step would be longer than asked for.
TEST(Settings, NoStepIsLongerThanTheCflNumberAllows) {
  for (const auto& [cfl, steps] : {std::pair{"0.31", 104},
                                   {"0.3199999", 101},
                                   {"0.3200001", 100},
                                   {"0.311", 103},
                                   {"1.29", 25},
                                   {"31", 2},
                                   {"33", 1}}) {
    const cases::Resolution resolution = make_case(bar_settings({{"cfl", cfl}})).resolution;  // T/Δt = 32/cfl
    EXPECT_EQ(resolution.steps, steps) << cfl;
    EXPECT_LE(resolution.dt * 100 * 32, std::stod(cfl) * (1 + 1e-9)) << cfl;
  }
}

TEST(Settings, ThePapersStepIsCflPointTwoAt512Cells) {
  const cases::Case c = make_case(bar_settings({{"dt", "4e-6"}}));
  EXPECT_EQ(c.resolution.steps, 2500);
}

TEST(Settings, DefaultsAreFilledInAndPartOfTheCase) {
  const cases::Case c = make_case(bar_settings({{"cfl", "0.3"}}));
  EXPECT_EQ(c.problem.parameters.at("amplitude"), 0.05);
  EXPECT_EQ(c.problem.parameters.at("youngs_modulus"), 1e4);
  EXPECT_EQ(c.scheme.boundary, "periodic");
  EXPECT_EQ(c, make_case(bar_settings({{"cfl", "0.3"}, {"param.amplitude", "0.05"}})));
  EXPECT_NE(c, make_case(bar_settings({{"cfl", "0.3"}, {"param.amplitude", "0.02"}})));
}

TEST(Settings, LaterOnesOverwriteEarlierOnes) {
  EXPECT_EQ(make_case(bar_settings({{"cfl", "0.3"}, {"cells", "64"}})).resolution.cells, 64);
}

TEST(Settings, AVelocityUpdateWithoutOrderIsTheSameAtEveryOrder) {
  plan::SeriesPlan series{"flip", bar_settings({{"cfl", "0.3"}, {"velocity_update", "xpic"}}), ""};
  EXPECT_EQ(plan::case_at(series, "order", 3, "").scheme.order, 3);
  series.settings.push_back({"velocity_update", "flip", "a.toml:9"});
  EXPECT_EQ(plan::case_at(series, "order", 3, "").scheme.order, 0);
}

TEST(Settings, AnErrorNamesTheLineOfTheSetting) {
  try {
    make_case(bar_settings({{"cfl", "0.3"}, {"basis", "bspline4"}}));
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("unknown basis 'bspline4' in a.toml:9 (known: linear, "), std::string::npos)
        << e.what();
  }
}

TEST(Settings, ChoicesOfVelocityUpdatesNameThoseThatHaveThem) {
  using Pair = std::pair<const char*, const char*>;
  for (const auto& [setting, takers] : {std::pair{Pair{"order", "2"}, "xpic or fmpm"},
                                        {Pair{"cfl_x", "1"}, "fmpm"},
                                        {Pair{"position", "particle"}, "flip"}}) {
    const auto settings = bar_settings({{"cfl", "0.1"}, {"velocity_update", "pic"}, setting});
    EXPECT_THAT([&] { make_case(settings); },
                testing::ThrowsMessage<UsageError>(testing::HasSubstr(std::string("only ") + takers + " takes it")));
  }
}

/// Two names of one method would compare nothing.
TEST(Settings, WallsHoldTheGridVelocitiesOfXpicWithEveryMethod) {
  const auto with = [](const char* update, const char* method) {
    return bar_settings({{"cfl", "0.1"}, {"velocity_update", update}, {"order", "3"}, {"wall_method", method}});
  };
  EXPECT_NO_THROW(make_case(with("fmpm", "velocity")));
  EXPECT_NO_THROW(make_case(with("xpic", "combined")));
  EXPECT_THAT([&] { make_case(with("xpic", "velocity")); },
              testing::ThrowsMessage<UsageError>(testing::HasSubstr("(use combined, which is the same)")));
}

TEST(Settings, WhatABasisDoesNotGoWith) {
  const auto of = [](const char* basis, const char* key, const char* value) {
    return bar_settings({{"cfl", "0.1"}, {"basis", basis}, {key, value}});
  };
  for (const char* basis : {"bspline2", "b2gimp"}) EXPECT_NO_THROW(make_case(of(basis, "velocity_update", "apic")));
  for (const char* basis : {"linear", "cpdi"})
    EXPECT_THAT([&] { make_case(of(basis, "velocity_update", "apic")); },
                testing::ThrowsMessage<UsageError>(
                    testing::HasSubstr("(bspline2, bspline3, ugimp, gimp, cpgimp, b2gimp: nodes a cell apart")));
  for (const char* basis : {"bspline2", "cpdi"}) EXPECT_NO_THROW(make_case(of(basis, "ppc", "1")));
  for (const char* basis : {"gimp", "cpgimp", "b2gimp"}) EXPECT_THROW(make_case(of(basis, "ppc", "1")), UsageError);
}

TEST(Settings, WhatTheConsistentMassDoesNotGoWith) {
  EXPECT_EQ(make_case(bar_settings({{"cfl", "0.1"}, {"mass", "consistent"}})).scheme.mass, cases::Mass::consistent);
  using Pairs = std::initializer_list<std::pair<const char*, const char*>>;
  for (const Pairs& wrong : {Pairs{{"boundary", "dirichlet"}, {"wall_acceleration", "difference"}},
                             Pairs{{"body_force", "grid"}}, Pairs{{"ppc", "1"}}}) {
    auto settings = bar_settings(wrong);
    settings.push_back({"cfl", "0.1", "a.toml:9"});
    EXPECT_NO_THROW(make_case(settings));
    settings.push_back({"mass", "consistent", "a.toml:9"});
    EXPECT_THROW(make_case(settings), UsageError);
  }
}

TEST(Settings, BoundariesPerFace) {
  EXPECT_EQ(canonical_boundary("xmax=free,xmin=dirichlet", 1, ""), "xmin=dirichlet,xmax=free");
  EXPECT_EQ(canonical_boundary("xmin=free,xmax=free", 1, ""), "free");
  EXPECT_EQ(boundary_faces("symmetry", 2, "").size(), 4U);
  EXPECT_THROW(boundary_faces("xmin=free,xmin=free,xmax=free", 1, ""), UsageError);
  EXPECT_THROW(boundary_faces("zmin=free,xmax=free", 1, ""), UsageError);
  EXPECT_THROW(boundary_faces("xmin=open,xmax=free", 1, ""), UsageError);
}

}  // namespace mpmvv::settings::settings_test
