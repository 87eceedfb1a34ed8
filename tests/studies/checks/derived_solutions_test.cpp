#include <gtest/gtest.h>

#include <set>

#include "studies/checks/check.hpp"

namespace mpmvv::checks::derived_solutions_test {

/// The problems for whose body force docs/problems.md has a closed form, each at two amplitudes where it has a limit.
TEST(DerivedSolutions, AllClosedFormBodyForcesAreCompared) {
  std::set<std::string> missing{"bar_b",    "bar_large_b",    "bar_rest_b",       "bar_rest_large_b",
                                "square_b", "square_large_b", "square_rest_b",    "square_rest_large_b",
                                "cube_b",   "cube_large_b",   "cube_rest_b",      "cube_rest_large_b",
                                "ring_b",   "ring_large_b",   "square_inverse_b", "square_inverse_large_b",
                                "shell_b",  "shell_large_b",  "vortex_b"};
  for (const records::Value& value : find_check("derived-solutions", "").run().values) {
    missing.erase(value.name);
    EXPECT_LT(value.value, 1e-10) << value.meaning;
  }
  EXPECT_EQ(missing, std::set<std::string>{});
}

}  // namespace mpmvv::checks::derived_solutions_test
