#include <algorithm>
#include <random>

#include "tests/solver/each_basis.hpp"
#include "tests/solver/each_update.hpp"
#include "tests/solver/scenes.hpp"

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

/// A body in one slab is never sorted anew.
TEST(SlabsOfAStep, HoldAtLeastAsManyParticlesAsItsSceneSays) {
  Scene<1> scene = drifting<1>(BSpline2{}, {50});
  bool sorted;
  run(scene, 100, &sorted);
  EXPECT_TRUE(sorted);
  scene.least_in_slab = scene.particles.size();
  run(scene, 100, &sorted);
  EXPECT_FALSE(sorted);
}

}  // namespace mpmvv::solver::repeatability_test
