#include "solver/parallel/active_nodes.hpp"

#include <mutex>

#include "solver/integrator/integrators.hpp"
#include "solver/step.hpp"
#include "tests/solver/each_basis.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::active_nodes_test {

/// What is visited of nodes that have mass where they say so.
std::vector<std::size_t> visited(std::size_t nodes, int threads, const auto& has_mass) {
  ThreadPool pool(threads);
  ActiveNodes active(nodes);
  std::mutex mutex;
  std::vector<std::size_t> lost, found;
  const auto lose = [&](std::size_t n) {
    const std::lock_guard lock(mutex);
    lost.push_back(n);
  };
  active.find(
      pool, [](std::size_t) { return true; }, lose);
  EXPECT_TRUE(lost.empty());
  active.find(pool, has_mass, lose);
  active.visit(pool, [&](std::size_t n) {
    const std::lock_guard lock(mutex);
    found.push_back(n);
  });
  std::ranges::sort(found);
  std::ranges::sort(lost);
  for (std::size_t n = 0, k = 0, gone = 0; n < nodes; ++n) {
    EXPECT_EQ(active.contain(n), has_mass(n)) << n;
    const bool stays = k < found.size() && found[k] == n, goes = gone < lost.size() && lost[gone] == n;
    EXPECT_NE(stays, goes) << n;
    k += stays, gone += goes;
  }
  return found;
}

TEST(ActiveNodesOfAGrid, AreThoseWithMassAlone) {
  const std::size_t nodes = 40'000;  // several chunks
  const auto every_third = [](std::size_t n) { return n % 3 == 0; };
  const auto all = [](std::size_t) { return true; };
  const auto none = [](std::size_t) { return false; };
  for (const int threads : {1, 2}) {
    const auto thirds = visited(nodes, threads, every_third);
    EXPECT_EQ(thirds.size(), nodes / 3 + 1);
    EXPECT_TRUE(std::ranges::all_of(thirds, every_third));
    EXPECT_EQ(visited(nodes, threads, all).size(), nodes);
    EXPECT_TRUE(visited(nodes, threads, none).empty());
  }
}

/// A block that crosses an empty grid as it is stretched.
template <int D>
Scene<D> travelling_block(const AnyBasis& basis, const AnyVelocityUpdate& update, std::string_view integrator) {
  Scene<D> scene = full_scene<D>(basis, 10, 2, Free{});
  Particles<D>& particles = scene.particles;
  scene.particles = particles_at<D>(lattice<D>(Vec<D>::Constant(0.2), 0.05,
                                               [] {
                                                 Index<D> count;
                                                 count.fill(6);
                                                 return count;
                                               }()),
                                    std::pow(0.05, D));
  set_widths(scene, 0.5);
  for (std::size_t p = 0; p < particles.size(); ++p) particles.v[p] = Vec<D>::Constant(8) + 4 * particles.x[p];
  scene.velocity_update = update;
  scene.integrator = integrator;
  return scene;
}

/// The energy after some steps, nodes without mass holding a large number in between.
template <int D>
double energy(const Scene<D>& scene, double elsewhere) {
  Step<D> s(scene);
  for (int step = 0; step < 100; ++step) {
    s.advance(2e-4);
    EXPECT_EQ(s.fault(), Fault::none);
    for (std::size_t n = 0; n < s.grid().size(); ++n)
      if (s.grid().m(n) == 0)
        for (auto* field : {&s.grid().v, &s.grid().a}) (*field)[n].setConstant(elsewhere);
  }
  Scene<D> end = scene;
  end.particles = s.particles();
  const Mpm<D> mpm(end);
  return mpm.kinetic_energy() + mpm.strain_energy();
}

class NodesWithoutMass : public WithEachBasis {};
INSTANTIATE_TEST_SUITE_P(, NodesWithoutMass, every_basis(), word_in_name);

TEST_P(NodesWithoutMass, AreNeverAskedForTheirFields) {
  for (const AnyVelocityUpdate& update :
       {AnyVelocityUpdate(Flip{}), AnyVelocityUpdate(Fmpm{3}), AnyVelocityUpdate(Xpic{2})})
    for (const std::string_view integrator : {"usl", "usf", "usavg+", "uvf", "rk4"}) {
      if (needs_whole_steps(update) && !integrator_named(integrator).has_whole_steps()) continue;  // refused
      const auto scene = travelling_block<2>(basis, update, integrator);
      EXPECT_EQ(energy(scene, 1e30), energy(scene, 0)) << integrator;
    }
}

TEST_P(NodesWithoutMass, LoseTheirVelocityAndAcceleration) {
  Mpm<2> mpm(travelling_block<2>(basis, Flip{}, "usl"));
  std::vector<bool> had_mass(mpm.grid().size());
  int losses = 0;
  for (int step = 0; step < 100; ++step) {
    ASSERT_TRUE(mpm.step(2e-4)) << mpm.fault();
    for (std::size_t n = 0; n < had_mass.size(); ++n) {
      const bool has_mass = mpm.grid().m(n) > 0;
      losses += had_mass[n] && !has_mass ? 1 : 0;
      had_mass[n] = has_mass;
      if (has_mass) continue;
      EXPECT_EQ(mpm.grid().v[n].norm() + mpm.grid().a[n].norm(), 0) << "node " << n;
    }
  }
  EXPECT_GT(losses, 0);
}

}  // namespace mpmvv::solver::active_nodes_test
