#include "studies/plan/estimates.hpp"

#include <gtest/gtest.h>

#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::plan::estimates_test {

double memory(const std::vector<settings::Setting>& more) {
  std::vector<settings::Setting> settings{
      {"problem", "cube", ""}, {"cells", "8", ""}, {"ppc", "2", ""}, {"cfl", "0.2", ""}, {"basis", "bspline2", ""}};
  settings.insert(settings.end(), more.begin(), more.end());
  return memory_estimate(settings::make_case(settings));
}

/// Vectors in space are padded to four components.
TEST(MemoryEstimate, CountsWhatSystemsOfMassesKeepOnEachNode) {
  constexpr double nodes = 13 * 13 * 13, field = 8 * 4 * nodes, scalar = 8 * nodes;
  const double plain = memory({});
  EXPECT_NEAR(memory({{"velocity_update", "fmpm", ""}, {"order", "2", ""}}) - plain, 2 * field, 1);
  EXPECT_NEAR(memory({{"mass", "consistent", ""}}) - plain, 6 * field + 3 * scalar, 1);
}

TEST(MemoryEstimate, CountsTheNodesKeptOfDomains) {
  constexpr double box = 8 * 27 + 4, particles = 8 * 8 * 8 * 8;
  const auto of = [](const char* order) {
    return memory({{"basis", "cpdi", ""}, {"velocity_update", "fmpm", ""}, {"order", order, ""}});
  };
  EXPECT_NEAR(of("3") - of("2"), box * particles, 1);
}

/// A bar of two slabs is visited one slab after the other.
TEST(SharedCase, HasParticlesForThreeSlabs) {
  const auto is_shared = [](const char* cells, int images = 1) {
    const std::vector<settings::Setting> bar{
        {"problem", "bar", ""}, {"cells", cells, ""}, {"ppc", "4", ""}, {"cfl", "0.2", ""}, {"basis", "bspline2", ""}};
    return can_be_shared(settings::make_case(bar), images);
  };
  EXPECT_FALSE(is_shared("383"));
  EXPECT_TRUE(is_shared("384"));
  EXPECT_FALSE(is_shared("384", 2));
}

}  // namespace mpmvv::plan::estimates_test
