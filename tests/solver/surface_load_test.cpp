#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "solver/kernels/map_surface_load.hpp"
#include "solver/step.hpp"
#include "tests/solver/each_basis.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::surface_load_test {

/// Forces that the test sets, on parts at the given offsets from the particles with these ids.
class GivenLoad final : public SurfaceLoad<2> {
 public:
  void add(std::uint32_t particle, const Vec<2>& offset, const Vec<2>& force) {
    parts_.push_back({particle, offset});
    forces_.push_back(force);
  }

  std::span<const Part> parts() const override { return parts_; }
  void forces(double t, Vec<2>* f) const override {
    for (const auto& force : forces_) *f++ = t * force;
  }

 private:
  std::vector<Part> parts_;
  Array<Vec<2>> forces_;
};

/// The middle of the unit square with a load that grows in time on two of its particles, which are turned: that gives
/// no stress.
class SurfaceLoads : public WithEachBasis {
 protected:
  SurfaceLoads() {
    scene.h = 0.125;
    scene.cells = {8, 8};
    scene.basis = settings(basis, 0.5).front().basis;
    scene.material = NeoHookeanLog{3000, 4000};
    scene.boundary.fill(Free{});
    scene.particles = particles_at<2>(lattice<2>({0.25, 0.25}, 0.0625, {8, 8}), 0.0625 * 0.0625);
    std::swap(scene.particles.x.front(), scene.particles.x.back());  // so that sorting moves them
    set_widths(scene, 0.5);
    scene.particles.F[0] = Eigen::Rotation2Dd(0.4).toRotationMatrix();
    scene.particles.F[63] = Eigen::Rotation2Dd(-0.7).toRotationMatrix();
    load.add(0, {0.03125, 0.01}, {3, -1});
    load.add(63, {-0.03125, 0}, {0.5, 2});
    scene.surface_load = &load;
  }

  Vec<2> place(int part) const {
    const std::size_t p = load.parts()[part].particle;
    return scene.particles.x[p] + scene.particles.F[p] * load.parts()[part].offset;
  }

  Scene<2> scene;
  GivenLoad load;
};
INSTANTIATE_TEST_SUITE_P(, SurfaceLoads, every_basis(), word_in_name);

TEST_P(SurfaceLoads, GiveTheGridTheirForceAndMoment) {
  const Vec<2> first = place(0), second = place(1);
  Step<2> s(scene);
  s.set_time(2);
  s.map_momentum_and_forces();
  Vec<2> force = Vec<2>::Zero();
  Mat<2> moment = Mat<2>::Zero();  // Σ x_i ⊗ f_i
  for (std::size_t n = 0; n < s.grid().size(); ++n) {
    const Vec<2> f = s.grid().f[n];
    force += f;
    moment += s.node_position(n) * f.transpose();
  }
  EXPECT_LT((force - 2 * Vec<2>(3.5, 1)).norm(), 1e-13);
  const Mat<2> exact = 2 * (first * Vec<2>(3, -1).transpose() + second * Vec<2>(0.5, 2).transpose());
  EXPECT_LT((moment - exact).norm(), 1e-13);
}

TEST_P(SurfaceLoads, GiveTheBodyTheirImpulse) {
  for (const int threads : {1, 2}) {
    scene.threads = threads;
    Mpm<2> mpm(scene);
    constexpr double dt = 1e-5;
    for (int k = 0; k < 10; ++k) ASSERT_TRUE(mpm.step(dt));
    Vec<2> momentum = Vec<2>::Zero();
    for (std::size_t p = 0; p < mpm.particles().size(); ++p) momentum += mpm.particles().m[p] * mpm.particles().v[p];
    const Vec<2> impulse = 45 * dt * dt * Vec<2>(3.5, 1);  // Σ_k t_k f Δt
    EXPECT_LT((momentum - impulse).norm(), 1e-10 * impulse.norm());
  }
}

TEST_P(SurfaceLoads, OnAParticleBeyondTheGridAreAFault) {
  scene.particles.x[63][0] = 2;
  Mpm<2> mpm(scene);
  EXPECT_FALSE(mpm.step(1e-5));
  EXPECT_EQ(mpm.fault(), "a particle left the domain");
}

}  // namespace mpmvv::solver::surface_load_test
