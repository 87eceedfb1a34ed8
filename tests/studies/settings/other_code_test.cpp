#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/settings/part.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::settings::other_code_test {

using support::UsageError;
using testing::HasSubstr;

using Given = std::initializer_list<std::pair<const char*, const char*>>;

cases::Case made(Given given) {
  std::vector<Setting> settings{{"cells", "16", "a.toml:1"}, {"ppc", "2", "a.toml:2"}, {"cfl", "0.2", "a.toml:3"}};
  for (const auto& [key, value] : given) settings.push_back({key, value, "a.toml:9"});
  return make_case(settings);
}

std::string complaint(Given given) {
  try {
    made(given);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "";
}

TEST(OtherCode, IsPartOfACase) {
  const cases::Case c = made({{"problem", "square-rest"}, {"code", "nairn"}, {"variant", "usl"}});
  EXPECT_EQ(c.scheme.code, "nairn");
  EXPECT_EQ(c.scheme.variant, "usl");
  EXPECT_EQ(c.scheme.force_form, cases::ForceForm::reference);
  EXPECT_EQ(made({{"problem", "square-rest"}, {"code", "nairn"}, {"force_form", "none"}}).scheme.force_form,
            cases::ForceForm::none);
}

TEST(OtherCode, TakesNoWordOfOurOwnSolver) {
  for (const auto& [key, value] : {std::pair{"basis", "linear"},
                                   {"integrator", "usl"},
                                   {"boundary", "periodic"},
                                   {"grid_offset", "0.5"},
                                   {"nodal_error", "true"}})
    EXPECT_THAT(complaint({{"problem", "square"}, {"code", "nairn"}, {key, value}}),
                HasSubstr(std::string(key) + " in a.toml:9 has no meaning for code 'nairn'"));
}

TEST(OtherCode, ItsWordsHaveNoMeaningWithoutIt) {
  for (const auto& [key, value] : {std::pair{"variant", "usl"}, {"force_form", "current"}, {"code_version", "1"}})
    EXPECT_THAT(complaint({{"problem", "square"}, {key, value}}), HasSubstr("has no meaning without code"));
}

TEST(OtherCode, NeedsASolutionAndAFreeSurface) {
  EXPECT_THAT(complaint({{"problem", "impact"}, {"code", "nairn"}}), HasSubstr("no exact solution"));
  EXPECT_THAT(complaint({{"problem", "ring"}, {"code", "nairn"}, {"param.poissons_ratio", "0.3"}}),
              HasSubstr("traction"));
  EXPECT_EQ(complaint({{"problem", "ring"}, {"code", "nairn"}, {"quarter", "true"}}), "");
}

TEST(OtherCode, HasTheNodesOfAQuarterOnItsPlanes) {
  const auto quarter = [](const char* cells) {
    return complaint({{"problem", "cube-rest"}, {"code", "nairn"}, {"quarter", "true"}, {"cells", cells}});
  };
  EXPECT_THAT(quarter("5"), HasSubstr("its quarter on 5 cells has planes of symmetry between nodes (an even number)"));
  EXPECT_EQ(quarter("6"), "");
}

TEST(OtherCode, MayHaveALawThatTheSolutionIsNotExactFor) {
  EXPECT_EQ(made({{"problem", "wave"}, {"code", "nairn"}}).scheme.material, "linear-elastic");
  EXPECT_EQ(made({{"problem", "wave"}, {"code", "nairn"}, {"material", "neo-hookean-log"}}).scheme.material,
            "neo-hookean-log");
  EXPECT_THAT(complaint({{"problem", "wave"}, {"material", "mie-gruneisen"}}),
              HasSubstr("it is of linear-elastic or neo-hookean-log"));
  EXPECT_THAT(complaint({{"problem", "square"}, {"material", "linear-elastic"}}),
              HasSubstr("(it is of neo-hookean-log)"));
  EXPECT_THAT(complaint({{"problem", "wave"}, {"material", "neo-hookean-log"}, {"stress_error", "true"}}),
              HasSubstr("is not exact"));
  EXPECT_THAT(
      complaint({{"problem", "wave"}, {"code", "nairn"}, {"material", "neo-hookean-log"}, {"stress_error", "true"}}),
      HasSubstr("stress_error with material 'neo-hookean-log', of which its solution is not exact (leave it out)"));
}

TEST(OtherCode, BlowsUpBeyondANumber) {
  EXPECT_THAT(complaint({{"problem", "square"}, {"code", "nairn"}, {"blowup_error", "-1"}}),
              HasSubstr("blowup_error = -1 (a number > 0)"));
}

TEST(OtherCode, RunsTheWholeBody) {
  EXPECT_FALSE(part_of(made({{"problem", "square"}, {"code", "nairn"}})).has_value());
}

TEST(OtherCode, IsNamedByAWord) {
  EXPECT_THAT(complaint({{"problem", "square"}, {"code", "a b"}}), HasSubstr("code = 'a b' in a.toml:9"));
}

}  // namespace mpmvv::settings::other_code_test
