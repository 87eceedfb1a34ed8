#include <gtest/gtest.h>

#include "tests/solver/each_update.hpp"
#include "tests/solver/scenes.hpp"

/// At which time of a step walls that accelerate take their velocity.
namespace mpmvv::solver::wall_times_test {

constexpr double acceleration = 1000;

/// A wall that starts from rest.
struct Start final : WallMotion {
  double x0;
  explicit Start(double x) : x0(x) {}
  double position(double t) const override { return x0 + acceleration * t * t / 2; }
  double velocity(double t) const override { return acceleration * t; }
  double gradient(double) const override { return 0; }
};

struct Gravity final : BodyForce<1> {
  void on_particles(double, std::span<const std::uint32_t> ids, std::span<const Vec<1>>, Vec<1>* b) const override {
    std::fill_n(b, ids.size(), Vec<1>(acceleration));
  }
  Vec<1> at_position(const Vec<1>&, double) const override { return Vec<1>(acceleration); }
};

/// Whether a body at rest is accelerated by the grid's velocity alone. An integrator that leaves it at that of the
/// step's start goes with `flip` only, and moves particles later.
bool advances_the_grid(std::string_view integrator) {
  Gravity gravity;
  Scene<1> scene;
  scene.h = 0.25;
  scene.cells = {10};
  scene.lower = Vec<1>(-0.75);
  scene.basis = BSpline2{};
  scene.material = NeoHookeanLog{0, 5000};
  scene.body_force = &gravity;
  scene.particles = particles_at<1>(lattice<1>(Vec<1>(0), 0.125, {8}), 0.125);
  scene.velocity_update = Pic{};
  scene.integrator = integrator;
  Mpm<1> mpm(scene);
  EXPECT_EQ(mpm.advance(1e-4, 1), 1) << mpm.fault();
  return std::abs(mpm.particles().v[0][0]) > 0;
}

/// A bar from 0 to 1 between walls, which a body force accelerates as they do: it moves as a whole, by 0.8 cells.
struct AcceleratedBar {
  static constexpr int cells = 16, steps = 80;
  static constexpr double dt = 0.2 / cells / 100;  // a fifth of the time in which a wave crosses a cell
  Start left{0}, right{1};
  Gravity gravity;
  Scene<1> scene;

  AcceleratedBar(const AnyVelocityUpdate& update, WallGradient gradient) {
    scene.h = 1.0 / cells;
    scene.cells = {cells + 6};
    scene.lower = Vec<1>(-2 * scene.h);
    scene.basis = BSpline2{};
    scene.material = NeoHookeanLog{0, 5000};
    scene.body_force = &gravity;
    scene.boundary = {Wall{&left, 1, gradient}, Wall{&right, 1, gradient}};
    scene.particles = particles_at<1>(lattice<1>(Vec<1>(0), scene.h / 2, {2 * cells}), scene.h / 2);
    scene.velocity_update = update;
    scene.wall_method = WallMethod::elimination;  // `combined` has modes that grow
  }

  /// Returns the displacements, and expects no strain.
  Array<double> displacements(std::string_view integrator) {
    scene.integrator = integrator;
    Mpm<1> mpm(scene);
    EXPECT_EQ(mpm.advance(dt, steps), steps) << mpm.fault();
    const auto& particles = mpm.particles();
    Array<double> u(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const std::uint32_t id = particles.id[p];
      u[id] = particles.x[p][0] - scene.particles.x[id][0];
      EXPECT_NEAR(particles.F[p](0, 0), 1, 1e-13);
      EXPECT_NEAR(particles.v[p][0], acceleration * dt * steps, 1e-11);
    }
    return u;
  }

  /// Expects that no integrator strains the bar, and that it moves by nearly a t²/2, the same with all of them.
  void expect_rigid_motion() {
    const double t = dt * steps;
    const auto usl = displacements("usl");
    for (const double u : usl) EXPECT_NEAR(u, acceleration * t * t / 2, 1.001 * acceleration * t * dt / 2);
    for (const std::string_view integrator : integrators_of_whole_steps()) {
      if (!advances_the_grid(integrator)) continue;
      SCOPED_TRACE(integrator);
      const auto u = displacements(integrator);
      for (std::size_t p = 0; p < u.size(); ++p) EXPECT_NEAR(u[p], usl[p], 1e-13);
    }
  }
};

/// The velocity that F follows has that of the wall at the time of its momenta, and so has the estimate of the
/// gradient.
TEST(WallTimes, ABodyThatAcceleratesWithItsWallsIsNotStrained) {
  for (const auto& update : every_velocity_update())
    for (const auto gradient : {WallGradient::given, WallGradient::estimated}) {
      SCOPED_TRACE(testing::Message() << name_of(update) << ", gradient " << static_cast<int>(gradient));
      AcceleratedBar(update, gradient).expect_rigid_motion();
    }
}

TEST(WallTimes, EveryIntegratorOfOursAdvancesTheGrid) {
  for (const std::string_view integrator : {"usl", "usl+", "usf", "usavg", "usavg+"})
    EXPECT_TRUE(advances_the_grid(integrator)) << integrator;
}

/// So with the mass matrix, too, where the velocities of free nodes depend on those held. Walls go with `fmpm` there.
TEST(WallTimes, NorIsItWithTheConsistentMass) {
  for (const auto gradient : {WallGradient::given, WallGradient::estimated}) {
    SCOPED_TRACE(static_cast<int>(gradient));
    AcceleratedBar bar(Fmpm{}, gradient);
    bar.scene.consistent_mass.emplace();
    bar.scene.consistent_mass->tolerance = 1e-14;
    bar.expect_rigid_motion();
  }
}

}  // namespace mpmvv::solver::wall_times_test
