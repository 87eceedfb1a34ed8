#include <gtest/gtest.h>

#include <cmath>

#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"

/// The problems that any code can run, by the solver.
namespace mpmvv::runs::outside_problems_test {

records::Record run(const std::string& problem, const std::string& basis, int cells,
                    const std::vector<settings::Setting>& more = {}) {
  std::vector<settings::Setting> settings{{"problem", problem, ""}, {"basis", basis, ""},
                                          {"integrator", "cd", ""}, {"cells", std::to_string(cells), ""},
                                          {"ppc", "2", ""},         {"cfl", "0.4", ""}};
  settings.insert(settings.end(), more.begin(), more.end());
  const records::Record record = run_case(settings::make_case(settings), 1);
  EXPECT_EQ(record.status, records::Status::ok) << problem << ": " << record.reason;
  return record;
}

double order(const std::string& problem, int coarse) {
  const auto error = [&](int cells) { return run(problem, "cpgimp", cells).error.l2; };
  return std::log2(error(coarse) / error(2 * coarse));
}

TEST(OutsideProblems, FromRestConvergeAtSecondOrder) {
  EXPECT_NEAR(order("bar-rest", 16), 2, 0.15);
  EXPECT_NEAR(order("square-rest", 16), 2, 0.15);
  EXPECT_NEAR(order("square-inverse", 16), 2, 0.15);
  EXPECT_LT(run("cube-rest", "cpgimp", 16).error.l2, 0.03 * 0.02)
      << "of the amplitude: its order is 1.3 up to here, 2.7 to the next mesh";
}

TEST(OutsideProblems, WithoutABodyForceConvergeOrAreExact) {
  EXPECT_NEAR(order("wave", 16), 2, 0.15);
  for (const char* basis : {"linear", "bspline2", "cpgimp"})
    EXPECT_LT(run("translation", basis, 16).error.linf, 1e-13) << basis;
}

/// At 1.25 periods; after whole ones that error is none to leading order.
records::Record wave(const std::string& material, const std::string& amplitude, int cells) {
  return run("wave", "cpgimp", cells,
             {{"material", material, ""}, {"param.amplitude", amplitude, ""}, {"end_time", "0.02155", ""}});
}

/// A body of a law of finite strain stays within the error that the solution states, and no refinement takes it away.
TEST(OutsideProblems, TheWaveOfAFiniteLawHasAFloor) {
  const records::Record small = wave("neo-hookean-log", "1e-6", 16), large = wave("neo-hookean-log", "0.02", 32);
  EXPECT_GT(small.error.l2, 100 * small.solution_floor);
  EXPECT_NEAR(small.error.l2 / wave("linear-elastic", "1e-6", 16).error.l2, 1, 0.01);
  EXPECT_LT(large.error.l2, large.solution_floor);
  EXPECT_GT(large.error.l2, 0.1 * large.solution_floor);
  EXPECT_NEAR(std::log2(large.error.l2 / wave("neo-hookean-log", "0.02", 64).error.l2), 0, 0.5);
  EXPECT_TRUE(std::isnan(run("wave", "cpgimp", 16).solution_floor));
}

}  // namespace mpmvv::runs::outside_problems_test
