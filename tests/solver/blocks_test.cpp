#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "solver/stencils/extent.hpp"
#include "solver/step.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::blocks_test {

TEST(Extents, AreOfAllParticlesOfABlockAndNoOthers) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> some(-1, 1);
  Array<Vec<2>> x(20);
  for (auto& at : x) at = Vec<2>::NullaryExpr([&] { return some(random); });
  for (int count = 1; count < 12; ++count) {
    Block<2> block(0);
    block.begin = 3, block.count = count;
    const Extent<2> extent(block, x);
    Vec<2> least = x[3], most = x[3];
    for (int k = 1; k < count; ++k) {
      least = least.cwiseMin(x[static_cast<std::size_t>(3 + k)]);
      most = most.cwiseMax(x[static_cast<std::size_t>(3 + k)]);
    }
    EXPECT_EQ(extent.least, least) << count;
    EXPECT_EQ(extent.most, most) << count;
  }
}

/// Whether a particle astray is found at every place of a block.
void expect_fault_at_every_place(double astray) {
  const Grid<2> grid(Vec<2>::Zero(), 0.1, {10, 10}, 1, 2);
  for (std::size_t count = 1; count < 10; ++count)
    for (std::size_t p = 0; p < count; ++p) {
      Particles<2> particles;
      particles.resize(count);
      for (auto& x : particles.x) x = {0.51, 0.47};
      particles.x[p][1] = astray;
      PointBlock<2, BSpline2::support> block(0);
      block.begin = 0;
      block.count = static_cast<int>(count);
      EXPECT_EQ(evaluate_stencils(BSpline2{}, particles, grid, true, block), Fault::outside) << astray << ' ' << p;
    }
}

TEST(PointBlocks, FindAParticleAstray) {
  expect_fault_at_every_place(1.3);
  expect_fault_at_every_place(-0.3);
  expect_fault_at_every_place(std::numeric_limits<double>::infinity());
  expect_fault_at_every_place(std::numeric_limits<double>::quiet_NaN());
}

template <class B>
void expect_sorted_by_nodes() {
  Scene<2> scene = full_scene<2>(B{}, 9, 3, Free{});
  std::mt19937 random(3);
  std::shuffle(scene.particles.x.begin(), scene.particles.x.end(), random);
  for (auto& x : scene.particles.x) x.array() += 0.01 * scene.h;  // off the places where nodes change
  const auto grid = grid_for<B, 2>(scene.lower, scene.h, scene.cells);
  ThreadPool alone(1);
  Slabs<2>(grid, B{}).sort(scene.particles, grid, alone);
  PointBlock<2, B::support> block(0);
  int last = 0;
  for (block.begin = 0; block.begin < scene.particles.size(); ++block.begin) {
    block.count = 1;
    ASSERT_EQ(evaluate_stencils(B{}, scene.particles, grid, false, block), Fault::none);
    EXPECT_LE(last, block.first[0]) << B::word;
    last = block.first[0];
  }
}

TEST(Slabs, SortParticlesByTheirNodes) {
  expect_sorted_by_nodes<Linear>();
  expect_sorted_by_nodes<BSpline2>();
  expect_sorted_by_nodes<BSpline3>();
  expect_sorted_by_nodes<BSpline2Open>();
  expect_sorted_by_nodes<Gimp>();
  expect_sorted_by_nodes<B2Gimp>();
}

/// In a periodic box particles that come back through a face ask for a sort before others have strayed far.
TEST(Slabs, AreSortedAnewWhicheverWayParticlesStray) {
  for (const double way : {20.0, -20.0}) {  // in cells
    Scene<1> scene = full_scene<1>(BSpline2{}, 50, 2, Free{});
    scene.particles = particles_at<1>(lattice<1>(Vec<1>(way > 0 ? 0.04 : 0.56), scene.h / 2, {40}), scene.h / 2);
    constexpr int steps = 100;
    const double dt = 0.2 * scene.h / 120;
    for (auto& v : scene.particles.v) v[0] = way * scene.h / (steps * dt);
    Step<1> s(scene);
    const std::int64_t before = s.moves();
    s.advance(dt, steps);
    EXPECT_EQ(s.fault(), Fault::none);
    EXPECT_GE(s.moves() - before, steps + 5) << way << ": a step moves them once, and a sort counts once more";
  }
}

template <int n>
void expect_packs_to_keep_numbers() {
  std::array<std::array<double, n>, 4> from, to{};
  for (std::size_t lane = 0; lane < 4; ++lane)
    for (std::size_t k = 0; k < n; ++k) from[lane][k] = static_cast<double>(10 * lane + k + 1);
  std::array<Pack, n> packs;
  load_packs<n>({from[0].data(), from[1].data(), from[2].data(), from[3].data()}, packs.data());
  for (std::size_t lane = 0; lane < 4; ++lane)
    for (std::size_t k = 0; k < n; ++k) EXPECT_EQ(packs[k][lane], from[lane][k]) << n;
  store_packs<n>(packs.data(), {to[0].data(), to[1].data(), to[2].data(), to[3].data()});
  EXPECT_EQ(to, from) << n;
}

TEST(Packs, ReadAndWriteTheNumbersOfFour) {
  expect_packs_to_keep_numbers<1>();
  expect_packs_to_keep_numbers<2>();
  expect_packs_to_keep_numbers<3>();
  expect_packs_to_keep_numbers<4>();
  expect_packs_to_keep_numbers<9>();
  expect_packs_to_keep_numbers<12>();
}

}  // namespace mpmvv::solver::blocks_test
