#include <gtest/gtest.h>

#include <random>

#include "solver/integrator/integrators.hpp"
#include "tests/solver/each_boundary.hpp"
#include "tests/solver/scenes.hpp"

namespace mpmvv::solver::every_boundary_test {

/// Steps of a scene that such boundaries end.
template <int D>
Particles<D> after_steps(Scene<D> scene, const AnyBoundary& boundary, int steps) {
  end_by(boundary, scene);
  Mpm<D> mpm(scene);
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(mpm.step(0.1 * scene.h / 120)) << mpm.fault();
  return mpm.particles();
}

template <int D>
void expect_identical(const Particles<D>& a, const Particles<D>& b) {
  EXPECT_TRUE(a.id == b.id && a.x == b.x && a.v == b.v && a.F == b.F);
}

Array<Padded<2>> random_field(const Grid<2>& grid) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-1, 1);
  Array<Padded<2>> field(grid.size());
  for (auto& v : field) v = Padded<2>(value(random), value(random));
  return field;
}

double product(const Array<Padded<2>>& a, const Array<Padded<2>>& b) {
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += a[n].dot(b[n]);
  return sum;
}

/// What holds nothing changes nothing; what does changes nothing the second time.
TEST(EveryBoundary, HoldsAtOnce) {
  for (const AnyBoundary& any : every_boundary())
    for (const Face face : {Face{0, false}, Face{0, true}, Face{1, false}, Face{1, true}}) {
      Grid<2> grid(Vec<2>::Zero(), 1, {6, 5}, 1, 2);
      const auto start = random_field(grid);
      auto once = start;
      const auto constrain = [&](auto& field) {
        std::visit([&](const auto& own) { own.constrain(grid, face, field); }, any);
      };
      constrain(once);
      auto twice = once;
      constrain(twice);
      EXPECT_TRUE(once == twice) << word_of(any);
      EXPECT_NE(once == start, std::visit([]<class B>(const B&) { return B::holds; }, any)) << word_of(any);
    }
}

/// The power of forces on velocities held is that of what is left of them on any velocities.
TEST(EveryBoundary, LeavesOfForcesWhatDrivesTheRest) {
  for (const AnyBoundary& any : every_boundary())
    std::visit(
        []<class B>(const B& boundary) {
          if constexpr (B::holds)
            for (const Face face : {Face{0, false}, Face{1, true}}) {
              Grid<2> grid(Vec<2>::Zero(), 1, {6, 5}, 1, 2);
              const auto v = random_field(grid), f = random_field(grid);
              auto held = v, driving = f;
              boundary.constrain(grid, face, held);
              boundary.constrain_transposed(grid, face, driving);
              EXPECT_NEAR(product(held, f), product(v, driving), 1e-13) << B::word;
            }
        },
        any);
}

TEST(EveryBoundary, IsNotSeenByABodyInTheMiddle) {
  Scene<2> scene = full_scene<2>(BSpline2{}, 12, 2);
  scene.particles = particles_at<2>(lattice<2>(Vec<2>(0.35, 0.4), scene.h / 2, {6, 5}), scene.h * scene.h / 4);
  for (std::size_t p = 0; p < scene.particles.size(); ++p)
    scene.particles.v[p] = 5 * Vec<2>(std::sin(9.0 * static_cast<double>(p)), std::cos(7.0 * static_cast<double>(p)));
  for (const auto integrator : integrator_words()) {
    scene.integrator = integrator;
    const auto free = after_steps(scene, Free{}, 30);
    for (const AnyBoundary& boundary : every_boundary()) {
      if (is_moved(boundary) && !integrator_named(integrator).has_whole_steps()) continue;  // refused
      SCOPED_TRACE(testing::Message() << integrator << " " << word_of(boundary));
      expect_identical(after_steps(scene, boundary, 30), free);
    }
  }
}

TEST(EveryBoundary, LeavesABodyAtRest) {
  const Scene<3> scene = full_scene<3>(BSpline2{}, 4, 2);
  for (const AnyBoundary& boundary : every_boundary()) {
    SCOPED_TRACE(word_of(boundary));
    const auto end = after_steps(scene, boundary, 5);
    for (std::size_t p = 0; p < end.size(); ++p)
      EXPECT_TRUE(end.x[p] == scene.particles.x[end.id[p]] && end.v[p].isZero(0) && end.F[p].isIdentity(0)) << p;
  }
}

TEST(EveryBoundary, ThreadsDoNotMatter) {
  Scene<2> scene = full_scene<2>(BSpline2{}, 40, 2);
  set_wave(scene, 2);
  for (const AnyBoundary& boundary : every_boundary()) {
    SCOPED_TRACE(word_of(boundary));
    scene.threads = 1;
    const auto one = after_steps(scene, boundary, 10);
    scene.threads = 3;
    expect_identical(after_steps(scene, boundary, 10), one);
  }
}

}  // namespace mpmvv::solver::every_boundary_test
