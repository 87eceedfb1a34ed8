#include "solver/mass_product.hpp"

#include <random>

#include "solver/mpm.hpp"
#include "solver/step.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::mass_product_test {

/// A body whose particles have masses, domains and velocities on the nodes of their own.
template <int D, class B>
class TurnedBody {
 public:
  /// Domains up to so many cells wide along each axis.
  explicit TurnedBody(double extent) : step_(scene(extent)), u_(step_.grid().size()) {
    std::mt19937 random(5);
    for (auto& velocity : u_) velocity = Padded<D>::NullaryExpr([&] { return some_(random); });
  }

  /// SᵀM S u, as one of so many.
  std::vector<Padded<D>> product(int most) {
    MassProduct<D> product(step_, most);
    product.prepare(step_);
    uses_cache_ = product.uses_cache();
    std::vector<Padded<D>> image(u_.size(), Padded<D>::Zero());
    product.add(step_, u_, image);
    return image;
  }

  bool uses_cache() const { return uses_cache_; }  ///< the last time

 private:
  static Scene<D> scene(double extent) {
    Scene<D> scene = full_scene<D>(B{}, 6, 2, Free{});
    std::mt19937 random(3);
    auto& particles = scene.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      particles.m[p] *= 1 + 0.5 * some_(random);
      particles.x[p] += 0.2 * scene.h * Vec<D>::NullaryExpr([&] { return some_(random); });
      if (!particles.R.empty()) particles.R[p] = Mat<D>::NullaryExpr([&] { return extent / D * some_(random); });
    }
    return scene;
  }

  static inline std::uniform_real_distribution<double> some_{-1, 1};
  Step<D> step_;
  std::vector<Padded<D>> u_;
  bool uses_cache_ = false;
};

template <int D, class B>
void expect_the_cache_to_change_nothing(double extent, bool fits) {
  TurnedBody<D, B> body(extent);
  const auto once = body.product(1);
  EXPECT_FALSE(body.uses_cache());
  const auto often = body.product(2);
  EXPECT_EQ(body.uses_cache(), fits);
  const double cell_mass = std::pow(1.0 / 6, D);
  for (std::size_t n = 0; n < once.size(); ++n)
    EXPECT_LT((once[n] - often[n]).template head<D>().norm(), 1e-14 * cell_mass) << D << "D, node " << n;
}

template <class B>
class MassProducts : public ::testing::Test {};
using Domains = ::testing::Types<Cpdi, B2Cpdi>;
TYPED_TEST_SUITE(MassProducts, Domains);

TYPED_TEST(MassProducts, AreTheSameOnceAndOften) {
  for (const double extent : {0.5, 1.0, 3.0}) {  // the last: wider than the cache takes
    expect_the_cache_to_change_nothing<1, TypeParam>(extent, extent < 3);
    expect_the_cache_to_change_nothing<2, TypeParam>(extent, extent < 3);
    expect_the_cache_to_change_nothing<3, TypeParam>(extent, extent < 3);
  }
}

/// A step depends on the particles as they are, and on nothing kept of where they were.
void expect_to_go_on_as_if_begun_anew(Scene<2> scene) {
  const double dt = 0.1 * scene.h / 120;
  set_wave(scene, 20);
  Mpm<2> going_on(scene);
  for (int k = 0; k < 40; ++k) ASSERT_TRUE(going_on.step(dt)) << going_on.fault();
  scene.particles = going_on.particles();
  Mpm<2> anew(scene);
  ASSERT_EQ(anew.particles().id, going_on.particles().id);
  ASSERT_TRUE(going_on.step(dt) && anew.step(dt));
  for (std::size_t p = 0; p < scene.particles.size(); ++p)
    EXPECT_LT((going_on.particles().v[p] - anew.particles().v[p]).norm(), 1e-10) << p;
}

TYPED_TEST(MassProducts, FollowTheParticles) {
  auto scene = full_scene<2>(TypeParam{}, 8, 2, Free{});
  scene.velocity_update = Fmpm{3};
  expect_to_go_on_as_if_begun_anew(scene);
  scene.velocity_update = Flip{};
  scene.consistent_mass = unregularised;
  scene.consistent_mass->lumped_share = 0.1;
  expect_to_go_on_as_if_begun_anew(scene);
}

/// Keeps the stencil of one particle in the plane, so many cells wide.
template <class B>
void keep_one(CpdiStencilCache<2>& cache, double extent, const Grid<2>& grid) {
  Particles<2> particles;
  particles.resize(1);
  particles.x[0] = {0.47, 0.52};
  particles.R = {extent * Mat<2>::Identity()};
  CpdiBlock<2, B::support> block(0);
  block.begin = 0, block.count = 1;
  EXPECT_EQ(evaluate_stencils(B{}, particles, grid, false, block), Fault::none);
  cache.clear();
  cache.keep(block, grid);
}

template <class B>
void expect_a_partition_of_unity() {
  const auto grid = grid_for<B, 2>(Vec<2>::Zero(), 0.125, {8, 8});
  CpdiStencilCache<2> cache(B::support, 1);
  for (const double extent : {0.1, 0.5, 1.0}) {
    keep_one<B>(cache, extent, grid);
    EXPECT_TRUE(cache.is_complete());
    const auto nodes = cache.template stencil<B::support + 1>(0, grid);
    const std::vector<Padded<2>> ones(grid.size(), Padded<2>::Ones());
    EXPECT_LT((nodes.gather(ones) - Padded<2>::Ones()).norm(), 1e-15);
  }
  keep_one<B>(cache, 2.5, grid);
  EXPECT_FALSE(cache.is_complete());
}

TEST(CpdiStencilCaches, AreAPartitionOfUnityWhileTheyFit) {
  expect_a_partition_of_unity<Cpdi>();
  expect_a_partition_of_unity<B2Cpdi>();
}

}  // namespace mpmvv::solver::mass_product_test
