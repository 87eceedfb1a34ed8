#include <gtest/gtest.h>

#include <cmath>

#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"

/// The problems that any code can run, by the solver.
namespace mpmvv::runs {
namespace outside_problems_test {

records::Record run(const std::string& problem, const std::string& basis, int cells) {
  const std::vector<settings::Setting> settings{{"problem", problem, ""}, {"basis", basis, ""},
                                                {"integrator", "cd", ""}, {"cells", std::to_string(cells), ""},
                                                {"ppc", "2", ""},         {"cfl", "0.4", ""}};
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

}  // namespace outside_problems_test
}  // namespace mpmvv::runs
