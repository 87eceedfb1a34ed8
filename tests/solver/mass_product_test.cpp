#include "solver/mass_product.hpp"

#include <numeric>
#include <optional>
#include <random>

#include "solver/mpm.hpp"
#include "solver/stencils/node_boxes.hpp"
#include "solver/step.hpp"
#include "tests/solver/each_basis.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::mass_product_test {

/// A body whose particles have masses, domains and velocities on the nodes of their own.
template <int D>
class TurnedBody {
 public:
  /// Domains up to so many cells wide along each axis.
  TurnedBody(const AnyBasis& basis, double extent, const AnyBoundary& boundary)
      : step_(scene(basis, extent, boundary)), u_(step_.grid().size()) {
    std::mt19937 random(5);
    for (auto& velocity : u_) velocity = Padded<D>::NullaryExpr([&] { return some_(random); });
    step_.map_momentum();
  }

  /// SᵀM S u, as one of so many.
  Array<Padded<D>> product(int most) {
    MassProduct<D> product(step_, most);
    product.prepare(step_);
    is_assembled_ = product.is_assembled();
    Array<Padded<D>> image(u_.size(), Padded<D>::Zero());
    product.add(step_, u_, image);
    step_.sum_images(image);
    return image;
  }

  bool is_assembled() const { return is_assembled_; }  ///< the last time
  const Grid<D>& grid() const { return step_.grid(); }

 private:
  static Scene<D> scene(const AnyBasis& basis, double extent, const AnyBoundary& boundary) {
    Scene<D> scene = full_scene<D>(basis, 6, 2, boundary);
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
  Array<Padded<D>> u_;
  bool is_assembled_ = false;
};

/// A particle of a domain reaches so far that no two corners are more than a cell apart.
bool fits(const AnyBasis& basis, double extent) {
  return width_of(basis) != ParticleWidth::domain || extent < 3;
}

template <int D>
void expect_the_same(const Array<Padded<D>>& a, const Array<Padded<D>>& b, double cell_mass) {
  for (std::size_t n = 0; n < a.size(); ++n)
    EXPECT_LT((a[n] - b[n]).template head<D>().norm(), 1e-14 * cell_mass) << D << "D, node " << n;
}

template <int D>
void expect_the_matrix_to_change_nothing(const AnyBasis& basis, double extent) {
  for (const AnyBoundary& boundary : {AnyBoundary(Free{}), AnyBoundary(Periodic{}), AnyBoundary(Mirror{})}) {
    TurnedBody<D> body(basis, extent, boundary);
    const auto once = body.product(1);
    EXPECT_FALSE(body.is_assembled());
    const auto often = body.product(100);
    EXPECT_EQ(body.is_assembled(), D < 3 && fits(basis, extent));
    expect_the_same<D>(once, often, std::pow(1.0 / 6, D));
  }
}

class MassProducts : public WithEachBasis {};
INSTANTIATE_TEST_SUITE_P(, MassProducts,
                         ::testing::Values(Linear{}, Gimp{}, BSpline2{}, BSpline3{}, B2Gimp{}, Cpdi{}, B2Cpdi{}),
                         word_in_name);

TEST_P(MassProducts, AreTheSameOnceAndOften) {
  for (const double extent : {0.5, 1.0, 3.0}) {  // the last: wider than the matrix takes
    expect_the_matrix_to_change_nothing<1>(basis, extent);
    expect_the_matrix_to_change_nothing<2>(basis, extent);
    expect_the_matrix_to_change_nothing<3>(basis, extent);
  }
}

/// A body that leaves nodes and comes to others, by the same matrix.
TEST_P(MassProducts, ForgetTheNodesThatABodyHasLeft) {
  Scene<2> scene = full_scene<2>(basis, 12, 2, Free{});
  scene.particles = particles_at<2>(lattice<2>(Vec<2>(0.1, 0.1), scene.h / 2, {8, 8}), scene.h * scene.h / 4);
  set_widths(scene, 0.5);
  Step<2> step(scene);
  step.particles().rate.assign(step.particles().size(), Vec<2>(0.2, 0.13));
  MassProduct<2> once(step, 1), often(step, 100);
  const Array<Padded<2>> u(step.grid().size(), Padded<2>(1, -2));
  for (int k = 0; k < 3; ++k) {
    step.map_momentum();
    often.prepare(step);
    ASSERT_TRUE(often.is_assembled());
    Array<Padded<2>> swept(u.size(), Padded<2>::Zero()), multiplied = swept;
    once.add(step, u, swept);
    often.add(step, u, multiplied);
    expect_the_same<2>(swept, multiplied, scene.h * scene.h);
    step.last_sweep(MoveByRate<2>{step.particles(), 1});
  }
  EXPECT_EQ(step.fault(), Fault::none);
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

class StepsWithMassProducts : public WithEachBasis {};
INSTANTIATE_TEST_SUITE_P(, StepsWithMassProducts,
                         ::testing::Values(Gimp{}, BSpline2{}, BSpline3{}, B2Gimp{}, Cpdi{}, B2Cpdi{}), word_in_name);

TEST_P(StepsWithMassProducts, FollowTheParticles) {
  auto scene = full_scene<2>(basis, 8, 2, Free{});
  scene.velocity_update = Fmpm{3};
  expect_to_go_on_as_if_begun_anew(scene);
  scene.velocity_update = Flip{};
  scene.consistent_mass = unregularised;
  scene.consistent_mass->lumped_share = 0.1;
  expect_to_go_on_as_if_begun_anew(scene);
}

/// The velocities after some steps, which are made at once or one by one, in the order of the particles' ids.
Array<Vec<2>> velocities(const Scene<2>& scene, int steps, bool at_once) {
  Step<2> step(scene);
  const double dt = 0.1 * scene.h / 120;
  for (int k = 0; k < (at_once ? 1 : steps); ++k) step.advance(dt, at_once ? steps : 1);
  EXPECT_EQ(step.fault(), Fault::none);
  EXPECT_GT(step.moves(), steps + 2) << "particles were not sorted on the way";
  Array<Vec<2>> v(scene.particles.size());
  for (std::size_t p = 0; p < v.size(); ++p) v[step.particles().id[p]] = step.particles().v[p];
  return v;
}

/// Only of steps made at once is the mapping in one visit with the last sweep of the step before, and made anew where
/// that finds that particles must be sorted.
TEST_P(StepsWithMassProducts, AreTheSameAtOnceAndOneByOne) {
  auto scene = full_scene<2>(basis, 24, 1);
  set_wave(scene, 20);
  for (auto& v : scene.particles.v) v[1] += 360;
  for (const AnyVelocityUpdate& update :
       {AnyVelocityUpdate(Fmpm{4}), AnyVelocityUpdate(Fmpm{4, 3}), AnyVelocityUpdate(Xpic{4})}) {
    scene.velocity_update = update;
    const auto at_once = velocities(scene, 20, true), one_by_one = velocities(scene, 20, false);
    for (std::size_t p = 0; p < at_once.size(); ++p) EXPECT_LT((at_once[p] - one_by_one[p]).norm(), 1e-9) << p;
  }
}

/// The sum of the weights in the box of one particle in the plane, so many cells wide; none if it does not fit.
std::optional<double> weights_in_box(const AnyBasis& basis, double cells, const Grid<2>& grid) {
  Particles<2> particles;
  particles.resize(1);
  particles.x[0] = {0.47, 0.52};
  particles.l = {Vec<2>::Constant(std::min(cells, 1.0))};
  particles.R = {cells * Mat<2>::Identity()};
  AnyBlock<2> any = make_block<2>(basis, 0);
  common<2>(any).begin = 0, common<2>(any).count = 1;
  EXPECT_EQ(evaluate<2>(basis, particles, grid, false, any), Fault::none);
  return std::visit(
      [&]<class Own>(const Own& block) -> std::optional<double> {
        NodeBoxes<2, box_width<Own>> boxes;
        if (!find_boxes(block, grid, boxes)) return std::nullopt;
        return std::accumulate(std::begin(boxes.N[0]), std::end(boxes.N[0]), 0.0);
      },
      any);
}

TEST_P(MassProducts, AreOfBoxesThatArePartitionsOfUnity) {
  const auto grid = grid_for<2>(basis, Vec<2>::Zero(), 0.125, {8, 8});
  for (const double cells : {0.1, 0.5, 1.0}) {
    const auto sum = weights_in_box(basis, cells, grid);
    ASSERT_TRUE(sum);
    EXPECT_NEAR(*sum, 1, 1e-15);
  }
  EXPECT_EQ(weights_in_box(basis, 2.5, grid).has_value(), fits(basis, 3));
}

}  // namespace mpmvv::solver::mass_product_test
