#include "solver/parallel/slabs.hpp"

#include <algorithm>
#include <random>

#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::slabs_test {

/// A particle at x whose domain is as wide as it may be, in a block of its own.
template <class B>
struct Widest {
  Particles<1> one;
  BlockOf<1, B> block{0};
  Fault fault;

  Widest(const Grid<1>& grid, double x) {
    one.resize(1);
    one.x[0] = Vec<1>(x);
    one.R = {Mat<1>(std::max(1, 2 * reach(B::width)))};
    block.begin = 0, block.count = 1;
    fault = evaluate_stencils(B{}, one, grid, true, block);
  }
};

/// The nodes reached by a particle at x with the widest width or domain: of the solver's bases by what it has compiled.
template <class B>
std::vector<int> nodes_of_the_widest(const Grid<1>& grid, double x) {
  const double width = std::max(1, 2 * reach(B::width));
  std::vector<int> nodes;
  if constexpr (std::is_constructible_v<AnyBasis, B>) {
    for (const auto& node : reached(Setting{B{}, width}, grid, Vec<1>(x))) nodes.push_back(node.node[0]);
  } else {
    Widest<B> widest(grid, x);
    EXPECT_EQ(widest.fault, Fault::none);
    for_nodes(widest.block, widest.one, grid, [&](std::ptrdiff_t n, double, const Vec<1>&) {
      ASSERT_GE(n, 0);
      ASSERT_LT(n, static_cast<std::ptrdiff_t>(grid.size()));
      nodes.push_back(grid.index(static_cast<std::size_t>(n))[0]);
    });
  }
  return nodes;
}

/// Particles on so many cells of width 1, the closer to the lower end the more of them.
Particles<1> crowd(int cells) {
  Particles<1> particles = full_scene<1>(Linear{}, cells, 30).particles;
  for (auto& x : particles.x) x[0] *= x[0] * cells;
  return particles;
}

/// Cardinal B-splines of any order, centred on the nodes: wider than the bases of the solver.
template <int order>
struct Spline {
  static constexpr std::string_view word = "spline";
  static constexpr int support = order;
  static constexpr int extra_inside = 1;
  static constexpr int ghost = (order + 1) / 2;
  static constexpr ParticleWidth width = ParticleWidth::none;

  static double position(int i, int) { return i; }

  int evaluate(const AxisPoint& at, double* N, double* dN) const {
    const double xi = at.xi + (order % 2 == 0 ? 0 : 0.5), span = std::floor(xi);
    cox_de_boor<order>(order + xi - span, order, 3 * order, N, dN);
    return static_cast<int>(span) - (order - 1) / 2;
  }
};

template <int order>
struct DomainSpline : Spline<order> {
  static constexpr int ghost = Spline<order>::ghost + domain_reach;
  static constexpr ParticleWidth width = ParticleWidth::domain;
};

template <class Any, class... More>
struct Together;
template <class... Some, class... More>
struct Together<std::variant<Some...>, More...> {
  using type = ::testing::Types<Some..., More...>;
};

template <class B>
class SlabsOf : public ::testing::Test {};
using SlabbedBases = Together<AnyBasis, Spline<5>, Spline<6>, Spline<7>, DomainSpline<6>>::type;
TYPED_TEST_SUITE(SlabsOf, SlabbedBases);

/// Not even one to which a particle adds nothing: what another slab adds at the same time could be lost. Where
/// four slabs just fit if particles stray so far, and with many more cells.
TYPED_TEST(SlabsOf, NextButOneShareNoNode) {
  for (const int stray : {1, 2, 3, 20}) {
    const int cells = 4 * (static_cast<int>(Slabs<1>::least_thickness<TypeParam>(stray)) + 1);
    const auto grid = grid_for<TypeParam, 1>(Vec<1>::Zero(), 1, {cells});
    Slabs<1> slabs(grid, TypeParam{});
    Particles<1> particles = crowd(cells);
    ThreadPool alone(1);
    slabs.sort(particles, grid, alone);
    ASSERT_GE(slabs.count(), 4);
    for (int s = 0; s + 2 < slabs.count(); ++s) {
      const auto below = nodes_of_the_widest<TypeParam>(grid, slabs.reach(s, grid).second);
      const auto above = nodes_of_the_widest<TypeParam>(grid, slabs.reach(s + 2, grid).first);
      EXPECT_LT(*std::max_element(below.begin(), below.end()), *std::min_element(above.begin(), above.end()));
    }
  }
}

/// The corners of its domain reach two cells further, and the spline two nodes beyond these.
TEST(Slabs, OfWideDomainsHoldTheNodesOfAllThatIsLetIn) {
  using Wide = DomainSpline<6>;
  const auto grid = grid_for<Wide, 1>(Vec<1>::Zero(), 1, {5});
  for (const double x : {-1.25, 6.25}) EXPECT_EQ(Widest<Wide>(grid, x).fault, Fault::outside) << x;
  for (const double x : {-1.0, 5.75}) EXPECT_FALSE(nodes_of_the_widest<Wide>(grid, x).empty()) << x;
}

TEST(Slabs, LetParticlesStrayUpToThreeCellsAsLongAsFourRemain) {
  const auto overlap = [](int cells) {
    const Grid<1> grid(Vec<1>::Zero(), 1, {cells}, 1, 2);
    Slabs<1> slabs(grid, Linear{});
    Particles<1> particles = crowd(cells);
    ThreadPool alone(1);
    slabs.sort(particles, grid, alone);
    return slabs.reach(0, grid).second - slabs.reach(1, grid).first;
  };
  EXPECT_EQ(overlap(39), 2);
  EXPECT_EQ(overlap(40), 4);
  EXPECT_EQ(overlap(47), 4);
  EXPECT_EQ(overlap(48), 6);
  EXPECT_EQ(overlap(1000), 6);
}

/// There sorting hardly takes time.
TEST(Slabs, LetParticlesStrayOneCellInSpace) {
  EXPECT_EQ(Slabs<2>(Grid<2>(Vec<2>::Zero(), 1, {4, 48}, 1, 2), Linear{}).count(), 4);
  EXPECT_EQ(Slabs<3>(Grid<3>(Vec<3>::Zero(), 1, {4, 4, 48}, 1, 2), Linear{}).count(), 6);
}

/// As even as the least thickness allows, and never thinner, wherever the grid lies.
TEST(Slabs, HoldAboutAsManyParticlesEach) {
  Particles<1> particles = crowd(80);
  const Vec<1> corner = Vec<1>::Constant(-17.5);
  for (auto& x : particles.x) x += corner;
  const Grid<1> grid(corner, 1, {80}, 1, 2);
  Slabs<1> slabs(grid, Linear{});
  ThreadPool alone(1);
  slabs.sort(particles, grid, alone);
  ASSERT_EQ(slabs.count(), 6);
  std::size_t most = 0, sum = 0;
  for (int s = 0; s < slabs.count(); ++s) {
    const auto [begin, end] = slabs.particles(s);
    const auto [lower, upper] = slabs.reach(s, grid);
    EXPECT_GE(upper - lower, static_cast<double>(Slabs<1>::least_thickness<Linear>(3) + 6));
    for (std::size_t p = begin; p < end; ++p) EXPECT_EQ(particles.x[p][0], std::clamp(particles.x[p][0], lower, upper));
    most = std::max(most, end - begin);
    sum += end - begin;
  }
  EXPECT_EQ(sum, particles.size());
  const double in_the_fullest_cells =
      2400 * std::sqrt(static_cast<double>(Slabs<1>::least_thickness<Linear>(3)) / 80.0);
  EXPECT_LE(static_cast<double>(most), in_the_fullest_cells + 1);
}

TEST(Slabs, AreNoMoreThanAskedFor) {
  const Grid<1> grid(Vec<1>::Zero(), 1, {400}, 1, 2);
  EXPECT_EQ(Slabs<1>(grid, Linear{}).count(), 32);
  EXPECT_EQ(Slabs<1>(grid, Linear{}, 3).count(), 3);
  EXPECT_EQ(Slabs<1>(grid, Linear{}, 100).count(), 32);
  EXPECT_EQ(Slabs<1>(grid, Linear{}, 0).count(), 1);
  EXPECT_EQ(Slabs<1>(Grid<1>(Vec<1>::Zero(), 1, {3}, 1, 2), Linear{}, 3).count(), 1);
}

TEST(Slabs, SortKeepsTheOrderWithinACell) {
  Scene<1> scene = full_scene<1>(Linear{}, 40, 3);
  std::shuffle(scene.particles.x.begin(), scene.particles.x.end(), std::mt19937(2));
  const Grid<1> grid(scene.lower, scene.h, scene.cells, 1, 2);
  Slabs<1> slabs(grid, Linear{});
  ThreadPool alone(1);
  slabs.sort(scene.particles, grid, alone);
  EXPECT_EQ(slabs.count(), 4);
  EXPECT_EQ(slabs.particles(0).first, 0U);
  EXPECT_EQ(slabs.particles(3).second, 120U);
  const auto cell = [&](std::size_t p) { return std::floor(scene.particles.x[p][0] / scene.h); };
  for (std::size_t p = 1; p < 120; ++p) {
    EXPECT_LE(cell(p - 1), cell(p));
    EXPECT_TRUE(cell(p - 1) < cell(p) || scene.particles.id[p - 1] < scene.particles.id[p]);
  }
  for (int s = 0; s < slabs.count(); ++s) {
    const auto [begin, end] = slabs.particles(s);
    const auto [least, most] = slabs.reach(s, grid);
    EXPECT_EQ(end - begin, 30U);
    for (std::size_t p = begin; p < end; ++p) {
      EXPECT_GE(scene.particles.x[p][0], least + (s > 0 ? 2 * scene.h : 0));
      EXPECT_LE(scene.particles.x[p][0], most);
    }
  }
}

}  // namespace mpmvv::solver::slabs_test
