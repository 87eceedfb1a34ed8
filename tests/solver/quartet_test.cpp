#include "solver/quartet.hpp"

#include <random>
#include <utility>

#include "solver/consistent_mass.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::quartet_test {

/// Particles on their way: up to 0.4 cells along each axis from where they were sorted, so that runs of particles with
/// the same nodes have all lengths, and with masses of their own.
template <int D, class B>
struct MovedBody {
  Scene<D> scene = full_scene<D>(B{}, 12, D == 1 ? 12 : 3, Free{});
  Grid<D> grid = grid_for<B, D>(scene.lower, scene.h, scene.cells);
  Slabs<D> slabs{grid, B{}};
  std::vector<Packed<D>> u{grid.size()};

  MovedBody() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> some(-1, 1);
    auto& particles = scene.particles;
    slabs.sort(particles, grid);
    for (std::size_t p = 0; p < particles.size(); ++p) {
      particles.m[p] *= 1 + 0.5 * some(random);
      for (int d = 0; d < D; ++d)
        particles.x[p][d] = std::clamp(particles.x[p][d] + 0.4 * scene.h * some(random), 0.0, 1.0);
    }
    for (auto& velocity : u) velocity = Packed<D>::NullaryExpr([&] { return some(random); });
  }

  std::vector<Packed<D>> round_trip(const auto& loop_of) {
    std::vector<Packed<D>> result(grid.size(), Packed<D>::Zero());
    Team team(1);
    EXPECT_EQ(sweep<Adds::to_nodes>(B{}, scene.particles, grid, slabs, team,
                                    loop_of(MapRoundTrip<D>{scene.particles, u, result})),
              Fault::none);
    return result;
  }
};

template <int D, class B>
void expect_the_same_as_alone() {
  MovedBody<D, B> body;
  const auto together = body.round_trip([](const auto& op) { return QuartetLoop{op}; });
  const auto alone = body.round_trip([](const auto& op) { return node_loop(op); });
  const double cell_mass = std::pow(body.scene.h, D);
  for (std::size_t n = 0; n < together.size(); ++n)
    EXPECT_LT((together[n] - alone[n]).template head<D>().norm(), 1e-14 * cell_mass) << "node " << n;
}

template <class B>
class QuartetLoops : public ::testing::Test {};
TYPED_TEST_SUITE(QuartetLoops, TestedBases);

TYPED_TEST(QuartetLoops, MapAsEachParticleAloneDoes) {
  expect_the_same_as_alone<1, TypeParam>();
  expect_the_same_as_alone<2, TypeParam>();
  expect_the_same_as_alone<3, TypeParam>();
}

template <int D>
using SplineBlock = PointBlock<D, BSpline2::support, Evaluates::weights>;

template <class B>
void expect_sorted_by_nodes() {
  Scene<2> scene = full_scene<2>(B{}, 9, 3, Free{});
  std::mt19937 random(3);
  std::shuffle(scene.particles.x.begin(), scene.particles.x.end(), random);
  for (auto& x : scene.particles.x) x.array() += 0.01 * scene.h;  // off the places where nodes change
  const auto grid = grid_for<B, 2>(scene.lower, scene.h, scene.cells);
  Slabs<2> slabs(grid, B{});
  slabs.sort(scene.particles, grid);
  PointBlock<2, B::support, Evaluates::weights> block;
  int last = 0;
  for (block.begin = 0; block.begin < scene.particles.size(); ++block.begin) {
    block.count = 1;
    ASSERT_EQ(evaluate_stencils(B{}, scene.particles, grid, block), Fault::none);
    EXPECT_LE(last, block.first[0]) << B::word;
    last = block.first[0];
  }
}

TEST(Quartets, FindParticlesSortedByTheirNodes) {
  expect_sorted_by_nodes<Linear>();
  expect_sorted_by_nodes<BSpline2>();
  expect_sorted_by_nodes<BSpline3>();
  expect_sorted_by_nodes<BSpline2Open>();
  expect_sorted_by_nodes<Gimp>();
  expect_sorted_by_nodes<B2Gimp>();
}

/// Counts how many particles go in which company.
struct Census {
  int* alone;
  int* fours;
  int* eights;

  void operator()(std::size_t, const auto&, const auto&, int) const { ++*alone; }
  template <int D, int K, int W>
  void operator()(const std::size_t*, const Quartets<D, K, W>&) const {
    ++*(W == 1 ? fours : eights);
  }
};

TEST(Quartets, TakeEightThenFourThenEachAlone) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 4, 15, Free{});
  const auto grid = grid_for<BSpline2, 1>(scene.lower, scene.h, scene.cells);
  SplineBlock<1> block;
  block.begin = 7, block.count = 30;  // the second and the third fifteen with the same nodes
  ASSERT_EQ(evaluate_stencils(BSpline2{}, scene.particles, grid, block), Fault::none);
  int alone = 0, fours = 0, eights = 0;
  QuartetLoop{Census{&alone, &fours, &eights}}(block, grid);
  EXPECT_EQ(eights, 2);
  EXPECT_EQ(fours, 2);
  EXPECT_EQ(alone, 2 * (15 - 8 - 4));
}

TEST(Quartets, StandTogetherInTheOrderOfTheirNodes) {
  Scene<2> scene = full_scene<2>(BSpline2{}, 4, 2, Free{});
  const auto grid = grid_for<BSpline2, 2>(scene.lower, scene.h, scene.cells);
  SplineBlock<2> block, sorted;
  block.begin = 0, block.count = 40;  // row by row, as the lattice makes them
  ASSERT_EQ(evaluate_stencils(BSpline2{}, scene.particles, grid, block), Fault::none);
  sorted = block;
  std::size_t particle[block_size<2>];
  sort_by_nodes(sorted, particle);
  for (int k = 0; k < block.count; ++k) {
    const auto p = static_cast<int>(particle[k]);
    EXPECT_EQ(sorted.first[k], block.first[p]);
    EXPECT_EQ(sorted.N[0][2][k], block.N[0][2][p]);
    EXPECT_EQ(sorted.N[1][0][k], block.N[1][0][p]);
    if (k == 0) continue;
    EXPECT_LT(std::pair(sorted.first[k - 1], particle[k - 1]), std::pair(sorted.first[k], particle[k]));
  }
}

}  // namespace mpmvv::solver::quartet_test
