#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "solver/boundary/orbits.hpp"
#include "solver/mpm.hpp"
#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::images_test {

constexpr Images kinds[]{Images::middle, Images::diagonal, Images::quarter_turns};

/// Where the next image of a node lies, counted from the middle of the first two axes.
template <int D>
auto next_place(Images images, const Grid<D>& grid, std::type_identity_t<Index<D>> i) {
  Vec<D> from_middle;
  const auto middle = [&](int d) { return d < 2 ? (grid.inside(d) - 1) / 2.0 : 0; };
  for (int d = 0; d < D; ++d) from_middle[d] = i[static_cast<std::size_t>(d)] - middle(d);
  from_middle = next_image(images, from_middle);
  for (int d = 0; d < D; ++d) i[static_cast<std::size_t>(d)] = static_cast<int>(from_middle[d] + middle(d));
  return i;
}

template <int D>
void fill_at_random(Grid<D>& grid) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-1, 1);
  for (auto& p : grid.p) {
    p.setZero();
    for (int k = 0; k <= D; ++k) p[k] = value(random);
  }
}

/// Every node gets what it and the nodes that have it as an image add, turned as they are.
template <int D>
void expect_sums(Images images, const Index<D>& cells) {
  SCOPED_TRACE(cells[0]);
  Grid<D> grid(Vec<D>::Zero(), 1, cells, 1, 2);
  fill_at_random(grid);
  auto sums = grid.p;
  for (std::size_t n = 0; n < grid.size(); ++n) {
    auto added = grid.p[n];
    Index<D> i = grid.index(n);
    for (int k = 1; k < count(images); ++k) {
      added = next_image(images, added);
      i = next_place(images, grid, i);
      sums[static_cast<std::size_t>(grid.node(i))] += added;
    }
    EXPECT_EQ(next_place(images, grid, i), grid.index(n)) << "the images do not come round";
  }
  Orbits<D> orbits(images, grid);
  orbits.take_all(grid);
  orbits.sum(grid.p);
  for (std::size_t n = 0; n < grid.size(); ++n)
    EXPECT_NEAR((grid.p[n] - sums[n]).template head<D + 1>().norm(), 0, 1e-14) << n;
}

TEST(Images, OfEveryNodeAreSummedOnceEach) {
  for (const Images images : kinds)
    for (const int cells : {4, 5}) {
      expect_sums<2>(images, {cells, cells});
      expect_sums<3>(images, {cells, cells, 3});
    }
  expect_sums<2>(Images::middle, {3, 6});
  expect_sums<3>(Images::middle, {7, 3, 2});
}

/// Particles on one side of a line through the middle reach nodes there alone, and so many beyond it.
template <int D>
void expect_the_same_on_nodes_with_mass(Images images, const Index<D>& cells) {
  Grid<D> grid(Vec<D>::Zero(), 1, cells, 1, 2);
  fill_at_random(grid);
  for (std::size_t n = 0; n < grid.size(); ++n) {
    const auto i = grid.index(n);
    grid.p[n][D] += 2;
    if (3 * i[1] - i[0] < cells[1] - 2) grid.p[n].setZero();
  }
  const auto alone = grid.p;
  Orbits<D> orbits(images, grid);
  orbits.take_all(grid);
  auto of_all = alone, of_those_with_mass = alone;
  orbits.sum(of_all);
  orbits.take_those_with_mass(grid, [&](std::size_t n) { return grid.m(n) > 0; });
  orbits.sum(of_those_with_mass);
  int others = 0;
  for (std::size_t n = 0; n < grid.size(); ++n) {
    const bool has_mass = alone[n][D] > 0;
    EXPECT_EQ(of_those_with_mass[n], has_mass ? of_all[n] : alone[n]) << n;
    others += has_mass && of_all[n] != alone[n] ? 1 : 0;
  }
  EXPECT_GT(others, 0);
}

TEST(Images, OfNodesWithMassAreSummedAsThoseOfAllNodes) {
  for (const Images images : kinds)
    for (const int cells : {6, 7}) {
      expect_the_same_on_nodes_with_mass<2>(images, {cells, cells});
      expect_the_same_on_nodes_with_mass<3>(images, {cells, cells, 2});
    }
}

TEST(Images, ThatAreNoneLeaveAFieldAsItIs) {
  Grid<1> line(Vec<1>::Zero(), 1, {4}, 1, 2);
  Grid<2> plane(Vec<2>::Zero(), 1, {4, 3}, 1, 2);
  fill_at_random(line);
  fill_at_random(plane);
  const auto p1 = line.p;
  const auto p2 = plane.p;
  Orbits<1> of_line(Images::none, line);
  Orbits<2> of_plane(Images::none, plane);
  of_line.take_all(line);
  of_plane.take_all(plane);
  of_line.sum(line.p);
  of_plane.sum(plane.p);
  EXPECT_EQ(line.p, p1);
  EXPECT_EQ(plane.p, p2);
}

TEST(Images, LeadBackAndForth) {
  const Vec<3> v(1, 2, 3);
  for (const Images images : kinds) {
    EXPECT_EQ(previous_image(images, next_image(images, v)), v);
    Vec<3> w = v;
    for (int k = 0; k < count(images); ++k) w = next_image(images, w);
    EXPECT_EQ(w, v);
  }
  EXPECT_EQ(next_image(Images::quarter_turns, Vec<2>(1, 0)), Vec<2>(0, 1)) << "from x to y";
}

TEST(Images, ThatGridOrBoundariesDoNotShareAreRefused) {
  const auto refused = [](const auto& change) {
    Scene<2> scene = full_scene<2>(Linear{}, 4, 2, Free{});
    scene.lower.setConstant(-0.5);
    for (auto& x : scene.particles.x) x += scene.lower;
    change(scene);
    try {
      Mpm<2>{scene};
    } catch (const std::invalid_argument& e) {
      return std::string(e.what()).starts_with("images that");
    }
    return false;
  };
  for (const Images images : kinds) {
    EXPECT_FALSE(refused([&](Scene<2>& scene) { scene.images = images; }));
    EXPECT_TRUE(refused([&](Scene<2>& scene) { scene.images = images, scene.cells[1] = 5; }));
    EXPECT_TRUE(refused([&](Scene<2>& scene) { scene.images = images, scene.boundary[2] = Mirror{}; }));
    EXPECT_TRUE(refused([&](Scene<2>& scene) { scene.images = images, scene.boundary.fill(Wall{}); }));
  }
  EXPECT_FALSE(refused([](Scene<2>& scene) { scene.images = Images::middle, scene.boundary[0] = Mirror{}; }));
  EXPECT_TRUE(refused([](Scene<2>& scene) { scene.images = Images::diagonal, scene.lower[1] = -1; }));
  EXPECT_TRUE(refused([](Scene<2>& scene) {
    scene.images = Images::quarter_turns;
    scene.boundary[0] = scene.boundary[2] = Mirror{};
  })) << "a mirror turned by a quarter is on the other side";
  EXPECT_TRUE(refused([](Scene<2>& scene) { scene.images = Images::quarter_turns, scene.lower.setZero(); }));
  Scene<1> bar = full_scene<1>(Linear{}, 4, 2);
  bar.images = Images::diagonal;
  EXPECT_THROW(Mpm<1>{bar}, std::invalid_argument);
}

}  // namespace mpmvv::solver::images_test
