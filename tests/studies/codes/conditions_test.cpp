#include "studies/codes/conditions.hpp"

#include <gmock/gmock.h>

#include "studies/settings/settings.hpp"

namespace mpmvv::codes::conditions_test {

using testing::DoubleNear;
using testing::ElementsAre;

Conditions conditions_of(std::vector<settings::Setting> settings) {
  settings.insert(settings.end(), {{"cells", "8", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}});
  return conditions(settings::make_case(settings));
}

TEST(Conditions, AreThoseOfTheSquare) {
  const Conditions all = conditions_of({{"problem", "square-rest", ""}});
  EXPECT_EQ(all.dimension, 2);
  EXPECT_EQ(all.density, 1);
  ASSERT_TRUE(all.elasticity);
  EXPECT_EQ(all.elasticity->youngs_modulus, 1e4);
  EXPECT_EQ(all.elasticity->poissons_ratio, 0.3);
  EXPECT_NEAR(bulk_modulus(*all.elasticity), 1e4 / (3 * (1 - 2 * 0.3)), 1e-9);
  EXPECT_EQ(all.wave_speed, 100);
  EXPECT_EQ(all.h, 0.125);
  EXPECT_NEAR(all.dt, 0.2 * 0.125 / 100, 1e-18);
  EXPECT_NEAR(all.end_time, 0.02, 1e-15);
  EXPECT_NEAR(all.cfl, 0.2, 1e-12);
  EXPECT_THAT(all.lower, ElementsAre(0, 0));
  EXPECT_THAT(all.upper, ElementsAre(1, 1));
  EXPECT_THAT(all.cells, ElementsAre(8, 8));
  EXPECT_THAT(all.boundary, ElementsAre("symmetry", "symmetry", "symmetry", "symmetry"));
}

/// The ring reaches 0.1 m beyond its outer radius of 1 m; a cell more is left for errors.
TEST(Conditions, SayHowFarTheGridReachesAroundARing) {
  const Conditions all = conditions_of({{"problem", "ring", ""}});
  EXPECT_THAT(all.cells, ElementsAre(20, 20));
  EXPECT_THAT(all.lower, ElementsAre(DoubleNear(-1.25, 1e-15), DoubleNear(-1.25, 1e-15)));
  EXPECT_THAT(all.upper, ElementsAre(DoubleNear(1.25, 1e-15), DoubleNear(1.25, 1e-15)));
  EXPECT_EQ(all.body, "between the radii 0.5 and 1 m around the origin");
}

TEST(Conditions, FollowTheGridsOffset) {
  const Conditions all = conditions_of({{"problem", "ring", ""}, {"grid_offset", "0.5", ""}});
  EXPECT_THAT(all.lower, ElementsAre(DoubleNear(-1.3125, 1e-15), DoubleNear(-1.3125, 1e-15)));
  EXPECT_THAT(all.cells, ElementsAre(21, 21));
}

TEST(Conditions, HaveNoYoungsModulusWhereTheLawHasNone) {
  EXPECT_FALSE(conditions_of({{"problem", "shock", ""}}).elasticity);
}

}  // namespace mpmvv::codes::conditions_test
