#include "reports/particle_spacing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

/// The widths of squares that stand for particles.
namespace mpmvv::reports::particle_spacing_test {

using records::ParticleError;

constexpr double spacing = 0.3;

/// A lattice of particles that is turned by an angle.
std::vector<ParticleError> lattice(int along, int across, double angle = 0) {
  std::vector<ParticleError> all;
  const double c = std::cos(angle), s = std::sin(angle);
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) all.push_back({spacing * (i * c - j * s), spacing * (i * s + j * c), 1});
  return all;
}

TEST(ParticleSpacing, IsThatOfALatticeInAnyDirection) {
  for (const double angle : {0.0, 0.4, 0.785398})
    for (const auto& [along, across] : {std::pair{20, 20}, {20, 3}, {3, 3}, {2, 2}})
      EXPECT_NEAR(particle_spacing(lattice(along, across, angle)), spacing, 1e-6) << along << " by " << across;
}

/// In these no particle has a ring of neighbours.
TEST(ParticleSpacing, IsThatOfOneOrTwoRows) {
  for (const double angle : {0.0, 0.4, 0.785398})
    for (const int rows : {1, 2})
      for (const int along : {2, 5, 9, 40})
        EXPECT_NEAR(particle_spacing(lattice(along, rows, angle)), spacing, 0.02 * spacing)
            << rows << " rows of " << along;
}

TEST(ParticleSpacing, DoesNotHangOnRoundOff) {
  std::vector<ParticleError> all = lattice(40, 2);
  for (std::size_t k = 0; k < all.size(); ++k) all[k].x += (k % 3 == 0 ? 1e-4 : -1e-4) * spacing;
  EXPECT_NEAR(particle_spacing(all), spacing, 0.01 * spacing);
}

TEST(ParticleSpacing, InSmallBodiesMostParticlesAreAtTheEdge) {
  for (const int across : {3, 4, 5}) EXPECT_NEAR(particle_spacing(lattice(5, across)), spacing, 1e-6) << across;
}

TEST(ParticleSpacing, IsAboutAParticlesShareWhereTheyLieInLittleOrder) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> aside(-0.2 * spacing, 0.2 * spacing);
  std::vector<ParticleError> all = lattice(20, 20);
  for (ParticleError& one : all) one.x += aside(random), one.y += aside(random);
  EXPECT_NEAR(particle_spacing(all), 1.1 * spacing, 0.1 * spacing);
}

TEST(ParticleSpacing, OfAStretchedLatticeLeavesFewGaps) {
  std::vector<ParticleError> all = lattice(20, 20);
  for (ParticleError& one : all) one.x *= 1.3, one.y /= 1.3;
  EXPECT_GT(particle_spacing(all), 1.05 * spacing);
  EXPECT_LT(particle_spacing(all), 1.3 * spacing);
}

TEST(ParticleSpacing, ALoneParticleIsInTheMiddleOfItsBody) {
  EXPECT_DOUBLE_EQ(particle_spacing({{0.005, -0.002, 1}}), 0.01);
  EXPECT_DOUBLE_EQ(particle_spacing({{0.005, -0.002, 1}, {0.005, -0.002, 2}}), 0.01) << "two in one place";
  EXPECT_GT(particle_spacing({{0, 0, 1}}), 0);
}

}  // namespace mpmvv::reports::particle_spacing_test
