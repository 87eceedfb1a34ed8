#include "studies/runs/particle_errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "studies/runs/run_case.hpp"
#include "studies/settings/settings.hpp"

namespace mpmvv::runs::particle_errors_test {

using records::ParticleError;

double rms(const std::vector<ParticleError>& errors) {
  double squares = 0;
  for (const ParticleError& one : errors) squares += one.error * one.error;
  return std::sqrt(squares / static_cast<double>(errors.size()));
}

/// n by n particles over the unit square, moved by (2, 3), each with another error.
ParticleErrors lattice(int n) {
  ParticleErrors errors(2, 1.0 / n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const solver::Vec<2> X((i + 0.5) / n, (j + 0.5) / n);
      errors.add<2>(X, X + solver::Vec<2>(2, 3), 1e-6 * (1 + i + n * j));
    }
  return errors;
}

TEST(ParticleErrors, AreThoseOfEachWhereTheyAreFew) {
  const auto errors = lattice(3).reduced();
  ASSERT_EQ(errors.size(), 9U);
  EXPECT_DOUBLE_EQ(errors[5].x, 2 + 1.5 / 3);
  EXPECT_DOUBLE_EQ(errors[5].y, 3 + 2.5 / 3);
  EXPECT_DOUBLE_EQ(errors[5].error, 8e-6);
}

TEST(ParticleErrors, AreThoseOfEqualSquaresWhereTheyAreMany) {
  const auto errors = lattice(120).reduced();
  EXPECT_EQ(errors.size(), 1600U) << "squares of 3 by 3";
  double squares = 0;
  for (int k = 1; k <= 120 * 120; ++k) squares += 1e-12 * k * k;
  EXPECT_NEAR(rms(errors), std::sqrt(squares) / 120, 1e-12);
  EXPECT_LE(lattice(130).reduced().size(), ParticleErrors::most);
}

TEST(ParticleErrors, OfASquareStandAtTheParticleNearestToItsMiddle) {
  const auto errors = lattice(120).reduced();
  EXPECT_NEAR(errors[0].x, 2 + 1.5 / 120, 1e-12);
  EXPECT_NEAR(errors[0].y, 3 + 1.5 / 120, 1e-12);
}

TEST(ParticleErrors, OfSquaresWithFourInTheMiddleAreEquallySpaced) {
  const auto errors = lattice(80).reduced();  // squares of 2 by 2
  ASSERT_EQ(errors.size(), 1600U);
  for (std::size_t k = 0; k < errors.size(); ++k)
    EXPECT_NEAR(errors[k].y - 3, (2.0 * static_cast<double>(k % 40) + 0.5) / 80, 1e-12) << k;
}

TEST(ParticleErrors, OfABodyInSpaceAreSeenAlongZ) {
  ParticleErrors errors(3, 0.5);
  for (const double z : {0.25, 0.75}) {
    const solver::Vec<3> X(0.25, 0.75, z);
    errors.add<3>(X, X, z < 0.5 ? 1 : 7);
  }
  const auto seen = errors.reduced();
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_DOUBLE_EQ(seen[0].y, 0.75);
  EXPECT_DOUBLE_EQ(seen[0].error, 5);
}

std::vector<settings::Setting> square() {
  return {
      {"problem", "square", ""}, {"basis", "bspline2", ""}, {"cells", "8", ""}, {"ppc", "2", ""}, {"cfl", "0.4", ""}};
}

TEST(ParticleErrors, OfARunHaveItsRootMeanSquare) {
  auto settings = square();
  EXPECT_TRUE(run_case(settings::make_case(settings), 1).particle_errors.empty());
  settings.push_back({"particle_errors", "true", ""});
  const records::Record r = run_case(settings::make_case(settings), 1);
  ASSERT_EQ(r.particle_errors.size(), 256U) << r.reason;
  EXPECT_NEAR(rms(r.particle_errors), r.error.l2, 1e-12 * r.error.l2);
  EXPECT_EQ(std::ranges::max(r.particle_errors, {}, &ParticleError::error).error, r.error.linf);
}

}  // namespace mpmvv::runs::particle_errors_test
