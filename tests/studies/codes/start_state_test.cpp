#include "studies/codes/start_state.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "studies/settings/settings.hpp"

namespace mpmvv::codes::start_state_test {

using testing::DoubleNear;
using testing::ElementsAre;

StartState state_of(const std::string& problem, std::vector<settings::Setting> more = {}) {
  more.insert(more.begin(), {{"problem", problem, ""}, {"cells", "4", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}});
  return start_state(settings::make_case(more));
}

/// W (56) and (57) at t = 0, on the middles of squares of width 1/8.
TEST(StartState, HoldsTheSquareAsItsPaperStartsIt) {
  const StartState state = state_of("square");
  const double pi = std::numbers::pi, A = 0.1, c = 100;
  ASSERT_EQ(state.dimension, 2);
  ASSERT_EQ(state.size(), 64U);
  for (std::size_t p = 0; p < state.size(); ++p) {
    const std::size_t column = p % 8, row = p / 8;
    const double X = (static_cast<double>(column) + 0.5) / 8, Y = (static_cast<double>(row) + 0.5) / 8;
    EXPECT_EQ(state.id[p], static_cast<std::int64_t>(p + 1));
    EXPECT_THAT(state.X[p], ElementsAre(DoubleNear(X, 1e-15), DoubleNear(Y, 1e-15), 0));
    EXPECT_THAT(state.x[p], ElementsAre(DoubleNear(X + A * std::sin(pi * X), 1e-15), DoubleNear(Y, 1e-15), 0));
    EXPECT_THAT(state.v[p], ElementsAre(DoubleNear(0, 1e-12), DoubleNear(A * pi * c * std::sin(pi * Y), 1e-12), 0));
    EXPECT_THAT(state.F[p], ElementsAre(DoubleNear(1 + A * pi * std::cos(pi * X), 1e-15), 0, 0, 0, DoubleNear(1, 1e-15),
                                        0, 0, 0, 1));
    EXPECT_DOUBLE_EQ(state.V[p], 1.0 / 64);
    EXPECT_DOUBLE_EQ(state.m[p], 1.0 / 64);
  }
  EXPECT_FALSE(is_at_rest(state, 100));
  EXPECT_FALSE(is_undeformed(state));
}

TEST(StartState, KnowsWhatStartsAtRest) {
  for (const char* problem : {"bar-rest", "square-rest", "square-inverse", "cube-rest"}) {
    const StartState state = state_of(problem);
    EXPECT_TRUE(is_at_rest(state, 100)) << problem;
    EXPECT_EQ(state.v, std::vector<Point>(state.size())) << problem;
    EXPECT_TRUE(is_undeformed(state)) << problem;
    EXPECT_EQ(state.X, state.x) << problem;
  }
  const StartState wave = state_of("wave");
  EXPECT_FALSE(is_at_rest(wave, 100));
  EXPECT_TRUE(is_undeformed(wave));
}

TEST(StartState, HasTheMassOfTheBodyInEveryDimension) {
  const auto mass = [](const StartState& state) { return std::accumulate(state.m.begin(), state.m.end(), 0.0); };
  EXPECT_NEAR(mass(state_of("bar", {{"param.density", "3", ""}})), 3, 1e-14);
  EXPECT_NEAR(mass(state_of("cube-rest")), 1, 1e-13);
  EXPECT_NEAR(mass(state_of("ring", {{"fill", "conforming", ""}})), std::numbers::pi * 0.75, 1e-13);
}

/// Bodies without a solution start as their problem says: two blocks that fly at each other.
TEST(StartState, HoldsWhatHasNoSolution) {
  const StartState state = state_of("impact");
  EXPECT_EQ(state.X, state.x);
  EXPECT_THAT(state.v.front(), ElementsAre(8.165, 0, 0));
  EXPECT_THAT(state.v.back(), ElementsAre(-8.165, 0, 0));
}

TEST(StartState, NumbersParticlesAsTheyFillTheBodyHoweverTheyAreShuffled) {
  const StartState plain = state_of("square"), shuffled = state_of("square", {{"shuffle", "7", ""}});
  ASSERT_EQ(plain.size(), shuffled.size());
  EXPECT_NE(plain.id, shuffled.id);
  for (std::size_t p = 0; p < shuffled.size(); ++p) {
    const auto same = static_cast<std::size_t>(shuffled.id[p] - 1);
    EXPECT_EQ(shuffled.X[p], plain.X[same]);
    EXPECT_EQ(shuffled.x[p], plain.x[same]);
    EXPECT_EQ(shuffled.F[p], plain.F[same]);
  }
}

}  // namespace mpmvv::codes::start_state_test
