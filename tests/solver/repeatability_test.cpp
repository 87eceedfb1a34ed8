#include <algorithm>
#include <random>

#include "solver/parallel/slabs.hpp"
#include "tests/solver/each_basis.hpp"
#include "tests/solver/each_update.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::repeatability_test {

/// The particles in the order of their creation.
template <int D>
Particles<D> in_order(Particles<D> particles) {
  Array<std::uint32_t> order(particles.size());
  for (std::size_t p = 0; p < order.size(); ++p) order[particles.id[p]] = static_cast<std::uint32_t>(p);
  ThreadPool alone(1);
  particles.permute(order, alone);
  return particles;
}

template <int D>
void expect_identical(const Particles<D>& a, const Particles<D>& b) {
  EXPECT_TRUE(a.x == b.x);
  EXPECT_TRUE(a.v == b.v);
  EXPECT_TRUE(a.F == b.F);
}

/// Steps one by one, and all at one go, which must be the same.
template <int D>
Particles<D> run(const Scene<D>& scene, int steps, bool* sorted = nullptr) {
  const double dt = 0.2 * scene.h / 120;
  Mpm<D> mpm(scene), at_one_go(scene);
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(mpm.step(dt)) << mpm.fault();
  EXPECT_EQ(at_one_go.advance(dt, steps), steps) << at_one_go.fault();
  EXPECT_EQ(at_one_go.steps(), steps);
  EXPECT_EQ(at_one_go.time(), mpm.time());
  EXPECT_TRUE(at_one_go.particles().id == mpm.particles().id);
  expect_identical(at_one_go.particles(), mpm.particles());
  if (sorted) *sorted = !std::is_sorted(mpm.particles().id.begin(), mpm.particles().id.end());
  return in_order(mpm.particles());
}

/// A wave that drifts through the slabs.
template <int D>
Scene<D> drifting(const AnyBasis& basis, const Index<D>& cells) {
  Scene<D> scene = full_scene<D>(basis, cells[D - 1], 2);
  scene.cells = cells;
  Index<D> count = cells;
  for (int& n : count) n *= 2;
  scene.particles = particles_at<D>(lattice<D>(scene.lower, scene.h / 2, count), std::pow(scene.h / 2, D));
  set_widths(scene, 0.5);
  set_wave(scene, 5);
  for (auto& v : scene.particles.v) v.array() += 90;
  return scene;
}

class Repeatability : public WithEachBasis {};
INSTANTIATE_TEST_SUITE_P(, Repeatability, every_basis(), word_in_name);

template <int D>
void expect_the_same_for_any_threads(Scene<D> scene, std::string_view integrator, int steps) {
  scene.integrator = integrator;
  scene.threads = 1;
  bool sorted;
  const auto one = run(scene, steps, &sorted);
  EXPECT_TRUE(sorted);
  for (const int threads : {2, 3}) {
    scene.threads = threads;
    expect_identical(one, run(scene, steps));
  }
}

TEST_P(Repeatability, NumberOfThreadsDoesNotMatter) {
  if (has_open_knots) GTEST_SKIP() << "nothing drifts between walls";
  for (const auto integrator : integrator_words()) {
    expect_the_same_for_any_threads(drifting<1>(basis, {50}), integrator, 100);
    if (integrator == "usl" || integrator == "usl+" || integrator == "rk4")  // between them they sweep as all others do
      expect_the_same_for_any_threads(drifting<2>(basis, {4, 40}), integrator, 60);
  }
  expect_the_same_for_any_threads(with_consistent_mass(drifting<2>(basis, {4, 40})), "usl", 60);
}

TEST(Repeatable, NumberOfThreadsDoesNotMatterWithAnyVelocityUpdate) {
  Scene<1> scene = drifting<1>(BSpline2{}, {50});
  for (const AnyVelocityUpdate& update : every_velocity_update())
    for (const std::string_view integrator : {"usl", "usf", "usl+"}) {
      SCOPED_TRACE(name_of(update));
      scene.velocity_update = update;
      expect_the_same_for_any_threads(scene, integrator, 100);
    }
}

TEST(Repeatable, NumberOfThreadsDoesNotMatterWithAHistory) {
  Scene<1> scene = drifting<1>(BSpline2{}, {50});
  scene.material = MieGruneisen{1, 9000, 1.44, 2, 440, 300, 0.4, 4};
  for (const std::string_view integrator : {"usl", "usf"}) expect_the_same_for_any_threads(scene, integrator, 100);
}

TEST_P(Repeatability, NumberOfThreadsDoesNotMatterBetweenWalls) {
  Scene<2> scene = full_scene<2>(basis, 33, 2, Dirichlet{});
  set_wave(scene, 2);
  const auto one = run(scene, 10);
  scene.threads = 3;
  expect_identical(one, run(scene, 10));
}

TEST(Repeatable, NumberOfThreadsDoesNotMatterOnManyNodes) {  // their loops are shared out, too
  Scene<2> scene = full_scene<2>(BSpline2{}, 200, 1);
  set_wave(scene, 5);
  const auto one = run(scene, 5);
  for (scene.threads = 2; scene.threads < 4; ++scene.threads) expect_identical(one, run(scene, 5));
}

TEST_P(Repeatability, OrderOfCreationDoesNotMatter) {
  Scene<2> scene = full_scene<2>(basis, 18, 2, has_open_knots ? AnyBoundary{Dirichlet{}} : Periodic{});
  set_wave(scene, 5);
  const auto ordered = run(scene, 40);
  Array<std::uint32_t> shuffle(scene.particles.size());
  std::iota(shuffle.begin(), shuffle.end(), 0U);
  std::shuffle(shuffle.begin(), shuffle.end(), std::mt19937(9));
  ThreadPool alone(1);
  scene.particles.permute(shuffle, alone);
  const auto shuffled = run(scene, 40);
  for (std::size_t p = 0; p < ordered.size(); ++p) {
    EXPECT_LT((ordered.x[p] - shuffled.x[p]).norm(), 1e-13);
    EXPECT_LT((ordered.v[p] - shuffled.v[p]).norm(), 1e-11);
    EXPECT_LT((ordered.F[p] - shuffled.F[p]).norm(), 1e-12);
  }
}

/// A motion that meets every face squarely, as the manufactured ones do; by a cutoff below all those tried.
Scene<2> squarely(const AnyBasis& basis, const AnyBoundary& boundary) {
  Scene<2> scene = full_scene<2>(basis, 10, 3, boundary);
  for (std::size_t p = 0; p < scene.particles.size(); ++p)
    for (int d = 0; d < 2; ++d) scene.particles.v[p][d] = 5 * std::sin(2 * M_PI * scene.particles.x[p][d]);
  scene.mass_cutoff = 1e-14;
  return scene;
}

/// A corner that overlaps a wall by ε gives a ghost node a mass and a force of order ε: what the cutoff leaves out
/// there changes the motion in proportion to it.
TEST_P(Repeatability, MassCutoffDoesNotMatter) {
  for (const AnyBoundary& boundary : std::vector<AnyBoundary>{Dirichlet{}, Symmetry{}}) {
    Scene<2> scene = squarely(basis, boundary);
    const auto finest = run(scene, 60);
    for (const double cutoff : {1e-13, 1e-12, 1e-11, 1e-10}) {
      scene.mass_cutoff = cutoff;
      const auto coarser = run(scene, 60);
      if (width_of(basis) != ParticleWidth::domain) expect_identical(finest, coarser);
      for (std::size_t p = 0; p < finest.size(); ++p)
        EXPECT_LT((finest.x[p] - coarser.x[p]).norm(), 10 * cutoff * scene.h);
    }
  }
}

TEST_P(Repeatability,
       MassCutoffHardlyMattersAtAFreeFace) {  // particles push nodes beyond it as they first reach them
  Scene<2> scene = squarely(basis, Free{});
  const auto finest = run(scene, 60);
  for (const double cutoff : {1e-13, 1e-12, 1e-11, 1e-10}) {
    scene.mass_cutoff = cutoff;
    const auto coarser = run(scene, 60);
    for (std::size_t p = 0; p < finest.size(); ++p) EXPECT_LT((finest.x[p] - coarser.x[p]).norm(), 1e-7 * scene.h);
  }
}

/// The nodes reached by a particle at x with the widest width or domain: of the solver's bases by what it has compiled.
template <class B>
std::vector<int> nodes_of_the_widest(const Grid<1>& grid, double x) {
  const double width = std::max(1, 2 * reach(B::width));
  std::vector<int> nodes;
  if constexpr (std::is_constructible_v<AnyBasis, B>) {
    for (const auto& node : reached(Setting{B{}, width}, grid, Vec<1>(x))) nodes.push_back(node.node[0]);
  } else {
    Particles<1> one;
    one.resize(1);
    one.x[0] = Vec<1>(x);
    one.R = {Mat<1>(width)};
    BlockOf<1, B> block(0);
    block.begin = 0, block.count = 1;
    EXPECT_EQ(evaluate_stencils(B{}, one, grid, true, block), Fault::none);
    for_nodes(block, one, grid, [&](std::ptrdiff_t n, double, const Vec<1>&) {
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

/// Not even one to which a particle adds nothing: what another slab adds at the same time could be lost.
TYPED_TEST(SlabsOf, NextButOneShareNoNode) {
  const auto grid = grid_for<TypeParam, 1>(Vec<1>::Zero(), 1, {100});
  Slabs<1> slabs(grid, TypeParam{});
  Particles<1> particles = crowd(100);
  ThreadPool alone(1);
  slabs.sort(particles, grid, alone);
  ASSERT_GT(slabs.count(), 4);
  for (int s = 0; s + 2 < slabs.count(); ++s) {
    const auto below = nodes_of_the_widest<TypeParam>(grid, slabs.reach(s, grid).second);
    const auto above = nodes_of_the_widest<TypeParam>(grid, slabs.reach(s + 2, grid).first);
    EXPECT_LT(*std::max_element(below.begin(), below.end()), *std::min_element(above.begin(), above.end()));
  }
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
  ASSERT_EQ(slabs.count(), 10);
  std::size_t most = 0, sum = 0;
  for (int s = 0; s < slabs.count(); ++s) {
    const auto [begin, end] = slabs.particles(s);
    const auto [lower, upper] = slabs.reach(s, grid);
    EXPECT_GE(upper - lower, Slabs<1>::least_thickness<Linear> + 2);
    for (std::size_t p = begin; p < end; ++p) EXPECT_EQ(particles.x[p][0], std::clamp(particles.x[p][0], lower, upper));
    most = std::max(most, end - begin);
    sum += end - begin;
  }
  EXPECT_EQ(sum, particles.size());
  const double in_the_fullest_cells = 2400 * std::sqrt(Slabs<1>::least_thickness<Linear> / 80.0);
  EXPECT_LE(static_cast<double>(most), in_the_fullest_cells + 1);
}

/// A body in one slab is never sorted anew.
TEST(Slabs, OfAStepHoldAtLeastAsManyParticlesAsItsSceneSays) {
  Scene<1> scene = drifting<1>(BSpline2{}, {50});
  bool sorted;
  run(scene, 100, &sorted);
  EXPECT_TRUE(sorted);
  scene.least_in_slab = scene.particles.size();
  run(scene, 100, &sorted);
  EXPECT_FALSE(sorted);
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
  EXPECT_EQ(slabs.count(), 5);
  EXPECT_EQ(slabs.particles(0).first, 0U);
  EXPECT_EQ(slabs.particles(4).second, 120U);
  const auto cell = [&](std::size_t p) { return std::floor(scene.particles.x[p][0] / scene.h); };
  for (std::size_t p = 1; p < 120; ++p) {
    EXPECT_LE(cell(p - 1), cell(p));
    EXPECT_TRUE(cell(p - 1) < cell(p) || scene.particles.id[p - 1] < scene.particles.id[p]);
  }
  for (int s = 0; s < slabs.count(); ++s) {
    const auto [begin, end] = slabs.particles(s);
    const auto [least, most] = slabs.reach(s, grid);
    EXPECT_EQ(end - begin, 24U);
    for (std::size_t p = begin; p < end; ++p) {
      EXPECT_GE(scene.particles.x[p][0], least + (s > 0 ? scene.h : 0));
      EXPECT_LE(scene.particles.x[p][0], most);
    }
  }
}

}  // namespace mpmvv::solver::repeatability_test
