#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::runs::grid_offset_test {

using Settings = std::vector<settings::Setting>;

records::Record run(Settings settings, const Settings& more = {}) {
  settings.insert(settings.end(), more.begin(), more.end());
  return run_case(settings::make_case(settings), 1);
}

Settings given(const std::string& problem, const std::string& basis, const std::string& cells) {
  return {{"problem", problem, "test"}, {"basis", basis, "test"}, {"cells", cells, "test"},
          {"ppc", "3", "test"},         {"cfl", "0.2", "test"},   {"integrator", "usl", "test"}};
}

const settings::Setting offset{"grid_offset", "0.3", "test"}, shuffled{"shuffle", "7", "test"};

TEST(GridOffset, ChangesWhereParticlesLieInCellsButNotTheSolution) {
  const double plain = run(given("bar", "bspline3", "32")).error.l2;
  const double moved = run(given("bar", "bspline3", "32"), {offset}).error.l2;
  EXPECT_NE(moved, plain);
  EXPECT_NEAR(moved / plain, 1, 0.1);
}

TEST(GridOffset, KeepsTheBalancesOfFreeBodies) {
  const records::Record record = run(given("impact", "gimp", "4"), {offset});
  EXPECT_EQ(record.status, records::Status::ok) << record.reason;
  EXPECT_LT(record.balance.momentum, 1e-12);
}

TEST(GridOffset, HasNoMeaningBetweenFixedFaces) {
  try {
    run(given("square", "bspline2", "8"), {{"boundary", "symmetry", "test"}, offset});
    FAIL() << "accepted";
  } catch (const support::UsageError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("grid_offset with boundary 'symmetry'"));
  }
  EXPECT_THROW(
      settings::make_case(Settings{
          {"problem", "bar", ""}, {"cells", "8", ""}, {"ppc", "2", ""}, {"cfl", "0.1", ""}, {"grid_offset", "1", ""}}),
      support::UsageError);
}

TEST(Shuffle, ChangesRoundOffAlone) {
  for (const char* problem : {"square", "ring"}) {
    const auto plain = run(given(problem, "cpgimp", "12")).error;
    const auto other = run(given(problem, "cpgimp", "12"), {shuffled}).error;
    EXPECT_NE(std::pair(other.l2, other.linf), std::pair(plain.l2, plain.linf)) << "the order of additions is the same";
    EXPECT_NEAR(other.l2 / plain.l2, 1, 1e-10);
  }
}

}  // namespace mpmvv::runs::grid_offset_test
