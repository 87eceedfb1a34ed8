#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/numbers.hpp"
#include "tests/solver/each_update.hpp"
#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::wall_test {

/// Where a wall is, and how fast, at any time: x = x0 + v0 t + c t², with a gradient of its own.
struct Ride final : WallMotion {
  double x0 = 0, v0 = 0, c = 0, gradient0 = 0, rate = 0;

  Ride(double x, double v, double gradient) : x0(x), v0(v), gradient0(gradient) {}
  double position(double t) const override { return x0 + v0 * t + c * t * t; }
  double velocity(double t) const override { return v0 + 2 * c * t; }
  double gradient(double t) const override { return gradient0 + rate * t; }
};

/// The coordinates of a grid's nodes along an axis.
template <int D>
std::vector<double> places(const Grid<D>& grid, int axis) {
  std::vector<double> x;
  for (int i = -grid.ghost(); i < grid.inside(axis) + grid.ghost(); ++i) x.push_back(grid.lower()[axis] + grid.h() * i);
  return x;
}

/// Ten cells of width 0.5 from 0 on with two ghost nodes, mass on the nodes from `first` to `last`.
Grid<1> line_of_nodes(int first, int last) {
  Grid<1> grid(Vec<1>(0), 0.5, {10}, 1, 2);
  for (int i = first; i <= last; ++i) grid.p[static_cast<std::size_t>(grid.node({i}))][1] = 1;
  return grid;
}

/// The indices of the nodes that a wall holds there.
std::vector<int> held(const Ride& ride, double depth, bool upper, int first, int last) {
  Grid<1> grid = line_of_nodes(first, last);
  MovingWall<1> wall({&ride, depth, WallGradient::zero}, {0, upper}, grid, places(grid, 0));
  wall.move(0, 0.1, grid.h());
  wall.meet(grid);
  Array<Padded<1>> field(grid.size(), Padded<1>(1));
  wall.clear(grid, field);
  std::vector<int> indices;
  for (std::size_t n = 0; n < grid.size(); ++n)
    if (field[n][0] == 0) indices.push_back(grid.index(n)[0]);
  return indices;
}

TEST(Wall, HoldsNodesUpToItsDepthAndThoseWithMassOutside) {
  const Ride at_4(4, 0, 0), at_4_1(4.1, 0, 0);  // node 8, and a fifth of a cell beyond it
  using Indices = std::vector<int>;
  EXPECT_EQ(held(at_4, 0, true, 0, 8), Indices{8});
  EXPECT_EQ(held(at_4, 0.9, true, 0, 9), (Indices{8, 9}));
  EXPECT_EQ(held(at_4, 1, true, 0, 9), (Indices{7, 8, 9})) << "at most d: a node at the depth itself is held";
  EXPECT_EQ(held(at_4, 2.5, true, 0, 12), (Indices{6, 7, 8, 9, 10, 11, 12})) << "ghosts too";
  EXPECT_EQ(held(at_4_1, 0.1, true, 0, 9), Indices{9});
  EXPECT_EQ(held(at_4_1, 0.2, true, 0, 9), (Indices{8, 9}));
  EXPECT_EQ(held(at_4_1, 1.1, true, 0, 9), (Indices{8, 9}));
  EXPECT_EQ(held(at_4_1, 1.2, true, 0, 8), (Indices{7, 8}));
  EXPECT_EQ(held(at_4, 2, true, 8, 9), (Indices{6, 7, 8, 9})) << "inside with mass or without";
  const Ride at_1(1, 0, 0);  // node 2
  EXPECT_EQ(held(at_1, 1, false, 1, 10), (Indices{1, 2, 3}));
  EXPECT_EQ(held(at_1, 1.9, false, -2, 10), (Indices{-2, -1, 0, 1, 2, 3}));
  EXPECT_EQ(held(Ride(-5, 0, 0), 1, false, -2, 10), Indices{}) << "a wall off the grid";
  EXPECT_EQ(held(Ride(9, 0, 0), 1, true, -2, 10), Indices{});
}

/// v_i = v_b + ∇v_b (x_i - x_wall), x_wall and ∇v_b of the step's start and v_b of its end; the other components stay.
TEST(Wall, HoldsALinearVelocityAlongItsNormal) {
  Ride ride(1.9, 3, -2);
  ride.c = 5, ride.rate = 7;
  Grid<2> grid(Vec<2>(-1, 0.5), 0.5, {8, 3}, 1, 2);
  for (auto& p : grid.p) p[2] = 1;
  MovingWall<2> wall({&ride, 1, WallGradient::given}, {0, true}, grid, places(grid, 0));
  const double t = 0.1, dt = 0.02;
  wall.move(t, dt, grid.h());
  wall.meet(grid);
  Array<Padded<2>> v(grid.size(), Padded<2>(100, 200));
  wall.hold(grid, v);
  for (std::size_t n = 0; n < grid.size(); ++n) {
    const double x = grid.lower()[0] + grid.h() * grid.index(n)[0], distance = x - ride.position(t);
    EXPECT_EQ(v[n][1], 200);
    EXPECT_DOUBLE_EQ(v[n][0], distance < -0.5 ? 100 : ride.velocity(t + dt) + ride.gradient(t) * distance);
  }
}

/// N (4) is exact for velocities that are linear across the wall, on each line of nodes by itself.
TEST(Wall, EstimatesTheGradientOfALinearVelocity) {
  for (const bool upper : {false, true})
    for (const double depth : {0.0, 0.5, 1.0, 2.3}) {
      const Ride ride(upper ? 2.1 : 0.3, 3, 99);
      Grid<2> grid(Vec<2>(-1, 0.5), 0.5, {8, 3}, 1, 2);
      for (auto& p : grid.p) p[2] = 1;
      const auto slope = [&grid](std::size_t n) { return 4 + 3.0 * grid.index(n)[1]; };
      const auto linear = [&](std::size_t n) {
        return 3 + slope(n) * (grid.lower()[0] + grid.h() * grid.index(n)[0] - ride.x0);
      };
      for (std::size_t n = 0; n < grid.size(); ++n) grid.v[n] = Padded<2>(linear(n), -1);
      MovingWall<2> wall({&ride, depth, WallGradient::estimated}, {0, upper}, grid, places(grid, 0));
      wall.move(0, 0.1, grid.h());
      wall.meet(grid);
      Array<Padded<2>> v(grid.size(), Padded<2>(1e9, 1e9));
      wall.hold(grid, v);
      int count = 0;
      for (std::size_t n = 0; n < grid.size(); ++n)
        if (v[n][0] != 1e9) {
          EXPECT_NEAR(v[n][0], linear(n), 1e-12);
          ++count;
        }
      EXPECT_GT(count, 0);
    }
}

/// A bar from -1 to 1 with this many cells, two particles in each, between walls at its ends.
template <int D>
struct StretchedBar {
  static constexpr double rate = 0.5;
  Ride left{-1, -rate, rate}, right{1, rate, rate};
  Scene<D> scene;

  StretchedBar(const AnyBasis& basis, const AnyVelocityUpdate& update, double depth,
               WallGradient gradient = WallGradient::given, int height = 4) {
    left.rate = right.rate = 0;
    scene.h = 0.125;
    scene.cells.fill(height);
    scene.cells[0] = 24;
    scene.lower = Vec<D>::Zero();
    scene.lower[0] = -1.5;
    scene.basis = basis;
    scene.material = NeoHookeanSquare{0, 40};
    scene.boundary.fill(Free{});
    scene.boundary[0] = Wall{&left, depth, gradient};
    scene.boundary[1] = Wall{&right, depth, gradient};
    Index<D> count;
    count.fill(2 * height);
    count[0] = 32;
    Vec<D> corner = Vec<D>::Zero();
    corner[0] = -1;
    scene.particles = particles_at<D>(lattice<D>(corner, scene.h / 2, count), std::pow(scene.h / 2, D));
    set_widths(scene, 0.5);
    for (std::size_t p = 0; p < scene.particles.size(); ++p) scene.particles.v[p][0] = rate * scene.particles.x[p][0];
    scene.velocity_update = update;
  }
};

/// Whether positions follow m⁻¹p in part, which no wall holds.
bool follows_momenta(const AnyVelocityUpdate& update) {
  const auto* flip = std::get_if<Flip>(&update);
  return flip ? flip->position != FlipPosition::first_order : std::holds_alternative<Xpic>(update);
}

/// Motion at constant rate is exact where walls hold every node: in a step x_wall and ∇v_b are those of its start.
TEST(Wall, KeepsUniformStretchExactly) {
  constexpr double dt = 1e-3, half = 1 + StretchedBar<2>::rate * dt / 2;
  for (const std::string_view integrator : {"usl", "usf", "usavg"}) {
    const double stretch = integrator == "usavg" ? half * half : 2 * half - 1;
    for (const auto& update : every_velocity_update())
      for (const auto method : {WallMethod::velocity, WallMethod::combined, WallMethod::elimination}) {
        if (has_affine_field(update)) continue;  // CPDI has no weights for it
        SCOPED_TRACE(testing::Message() << integrator << " " << name_of(update));
        StretchedBar<2> bar(Cpdi{}, update, 100);
        bar.left.gradient0 = bar.right.gradient0 = StretchedBar<2>::rate;
        bar.scene.integrator = integrator;
        bar.scene.wall_method = method;
        Mpm<2> mpm(bar.scene);
        ASSERT_TRUE(mpm.step(dt)) << mpm.fault();
        for (std::size_t p = 0; p < bar.scene.particles.size(); ++p) {
          const Vec<2> X = bar.scene.particles.x[mpm.particles().id[p]];
          if (!follows_momenta(update)) {
            EXPECT_NEAR(mpm.particles().x[p][0], X[0] * (1 + bar.rate * dt), 1e-12);
          }
          EXPECT_NEAR(mpm.particles().F[p](0, 0), stretch, 1e-13);
        }
      }
  }
}

void disturb(Particles<1>& particles) {
  for (std::size_t p = 0; p < particles.size(); ++p) particles.v[p][0] += 0.3 * std::sin(9.0 * static_cast<double>(p));
}

Array<Vec<1>> velocities(const AnyVelocityUpdate& update, WallMethod method, double depth = 1.5) {
  StretchedBar<1> bar(Cpdi{}, update, depth);
  disturb(bar.scene.particles);
  bar.scene.wall_method = method;
  Mpm<1> mpm(bar.scene);
  for (int k = 0; k < 5; ++k) EXPECT_TRUE(mpm.step(1e-3)) << mpm.fault();
  return mpm.particles().v;
}

double distance(const Array<Vec<1>>& a, const Array<Vec<1>>& b) {
  double largest = 0;
  for (std::size_t p = 0; p < a.size(); ++p) largest = std::max(largest, (a[p] - b[p]).norm());
  return largest;
}

/// With one term nothing is expanded, and the wall methods are one; with two, elimination is the combined method.
TEST(Wall, MethodsAgreeWhereNothingIsExpanded) {
  using enum WallMethod;
  const auto one = velocities(Fmpm{1}, combined);
  for (const auto method : {velocity, lumped, elimination})
    EXPECT_LT(distance(velocities(Fmpm{1}, method), one), 1e-13);
  EXPECT_LT(distance(velocities(Fmpm{2}, elimination), velocities(Fmpm{2}, combined)), 1e-13);
  EXPECT_GT(distance(velocities(Fmpm{3}, elimination), velocities(Fmpm{3}, combined)), 1e-5);
  EXPECT_LT(distance(velocities(Pic{}, combined), one), 1e-3) << "held as well: 0.06 where not";
}

/// Elimination tends to the consistent mass with the same nodes held.
TEST(Wall, EliminationTendsToTheConsistentMass) {
  StretchedBar<1> bar(BSpline2{}, Fmpm{1}, 1.5);
  disturb(bar.scene.particles);
  bar.scene.wall_method = WallMethod::elimination;
  const auto after_a_step = [&bar](int order) {
    bar.scene.velocity_update = Fmpm{order};
    Mpm<1> mpm(bar.scene);
    EXPECT_TRUE(mpm.step(1e-4));
    return mpm.particles().v;
  };
  bar.scene.consistent_mass = unregularised;
  const auto exact = after_a_step(1);
  bar.scene.consistent_mass.reset();
  double last = infinity;
  for (const int order : {1, 4, 16, 64, 256}) {
    const double now = distance(after_a_step(order), exact);
    EXPECT_LT(now, last);
    last = now;
  }
  EXPECT_LT(last, 1e-6);
}

/// Particles gain the momentum m_i a_i Δt of all nodes; walls give to what they hold the stress times the area of the
/// section, and hold it at rest.
TEST(Wall, ReactsWithTheStressOfTheBody) {
  StretchedBar<2> bar(Cpdi{}, Flip{}, 1);
  bar.left = Ride(-1.25, 0, 0), bar.right = Ride(1.25, 0, 0);
  auto& particles = bar.scene.particles;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    particles.v[p].setZero();
    particles.x[p][0] *= 1.25;
    particles.F[p](0, 0) = 1.25;
    particles.R[p] = particles.F[p] * particles.R0[p];
  }
  Mpm<2> mpm(bar.scene);
  const double dt = 1e-3, P = 40 * (1.25 - 1 / 1.25), area = 0.5;
  ASSERT_TRUE(mpm.step(dt));
  double left = 0, right = 0, gain = 0, momentum = 0;
  for (std::size_t n = 0; n < mpm.grid().size(); ++n) {
    const double m_a = mpm.grid().m(n) * mpm.grid().a[n][0], x = mpm.node_position(n)[0];
    if (x < -1) left += m_a - mpm.grid().f[n][0];
    if (x > 1) right += m_a - mpm.grid().f[n][0];
    gain += m_a * dt;
  }
  for (std::size_t p = 0; p < particles.size(); ++p) momentum += mpm.particles().m[p] * mpm.particles().v[p][0];
  EXPECT_NEAR(left, -P * area, 1e-10);
  EXPECT_NEAR(right, P * area, 1e-10);
  EXPECT_NEAR(momentum, gain, 1e-13);
  for (const auto& v : mpm.particles().v) EXPECT_LT(v.norm(), 1e-12);
}

TEST(Wall, ThreadsDoNotMatter) {
  StretchedBar<2> bar(B2Cpdi{}, Fmpm{4}, 1.5, WallGradient::estimated, 40);
  bar.scene.least_in_slab = 1;
  const auto run = [&bar](int threads) {
    bar.scene.threads = threads;
    Mpm<2> mpm(bar.scene);
    for (int k = 0; k < 20; ++k) EXPECT_TRUE(mpm.step(1e-3)) << mpm.fault();
    return mpm.particles();
  };
  const auto one = run(1), two = run(2);
  EXPECT_TRUE(one.x == two.x && one.v == two.v && one.F == two.F);
}

TEST(Wall, NeedsAMotion) {
  Scene<1> scene = full_scene<1>(Linear{}, 8, 2, Free{});
  scene.boundary[0] = Wall{};
  EXPECT_THROW(Mpm<1>{scene}, std::invalid_argument);
}

}  // namespace mpmvv::solver::wall_test
