#include "solver/step.hpp"
#include "tests/numbers.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::apic_test {

template <class B>
class Affine : public ::testing::Test {};
using SpreadBases = ::testing::Types<BSpline2, BSpline3, Gimp>;
TYPED_TEST_SUITE(Affine, SpreadBases);

/// A free block of unequal particles in the middle of its grid, moving as v = w + A x.
template <class B>
Scene<2> block_in_motion(const Vec<2>& w, const Mat<2>& A, double stiffness) {
  Scene<2> scene;
  scene.cells = {12, 12};
  scene.h = 0.1;
  scene.basis = B{};
  scene.boundary.fill(Free{});
  scene.material = NeoHookeanLog{0, stiffness};
  scene.velocity_update = Apic{};
  Array<Vec<2>> places;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 6; ++j)
      places.emplace_back(0.41 + 0.05 * i + 0.004 * std::sin(3.0 * j), 0.44 + 0.05 * j + 0.003 * std::cos(5.0 * i));
  scene.particles = particles_at<2>(places, 0.05);
  set_widths(scene, 0.5);
  for (std::size_t p = 0; p < scene.particles.size(); ++p) {
    scene.particles.m[p] *= 1 + 0.3 * std::sin(static_cast<double>(p));
    scene.particles.v[p] = w + A * scene.particles.x[p];
  }
  return scene;
}

/// Σ m x × v, and what the affine fields turn with, m D : C, where D_p = `inertia` I.
double angular_momentum(const Particles<2>& particles, double inertia) {
  double sum = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Vec<2>&x = particles.x[p], &v = particles.v[p];
    sum += particles.m[p] * (x[0] * v[1] - x[1] * v[0]);
    if (!particles.C.empty()) sum += particles.m[p] * inertia * (particles.C[p](1, 0) - particles.C[p](0, 1));
  }
  return sum;
}

TYPED_TEST(Affine, LinearFieldsPassTheGridUnchanged) {
  Mat<2> A;
  A << 0.3, -0.8, 0.5, -0.1;
  const Vec<2> w(0.2, -0.4);
  Scene<2> scene = block_in_motion<TypeParam>(w, A, 0);
  Step<2> s(std::move(scene));
  auto& particles = s.particles();
  for (std::size_t p = 0; p < particles.size(); ++p) particles.C[p] = A;
  const double dt = 1e-3;
  s.advance(dt);
  ASSERT_EQ(s.fault(), Fault::none);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Vec<2> X = particles.x[p] - dt * particles.v[p];
    EXPECT_LT((particles.v[p] - (w + A * X)).norm(), 1e-14);
    EXPECT_LT((particles.C[p] - A).norm(), 1e-12);
  }
}

TYPED_TEST(Affine, KeepsMomentum) {
  Mat<2> A;
  A << 0.3, -0.8, 0.5, -0.1;
  Mpm<2> mpm(block_in_motion<TypeParam>({0.2, -0.4}, A, 100));
  const auto momentum = [&mpm] {
    Vec<2> sum = Vec<2>::Zero();
    for (std::size_t p = 0; p < mpm.particles().size(); ++p) sum += mpm.particles().m[p] * mpm.particles().v[p];
    return sum;
  };
  const Vec<2> before = momentum();
  for (int step = 0; step < 50; ++step) ASSERT_TRUE(mpm.step(1e-3));
  EXPECT_LT((momentum() - before).norm(), 1e-13 * before.norm());
}

/// The angular momentum that is left of a spinning elastic block after fifty steps, over that at the start.
template <class B>
double spin_left(const AnyVelocityUpdate& update, double inertia, std::string_view integrator = "usl") {
  Mat<2> spin;
  spin << 0, -1, 1, 0;
  Scene<2> scene = block_in_motion<B>(-spin * Vec<2>(0.6, 0.575), spin, 100);
  scene.velocity_update = update;
  scene.integrator = integrator;
  Step<2> s(std::move(scene));
  for (auto& C : s.particles().C) C = spin;
  const double before = angular_momentum(s.particles(), inertia);
  for (int step = 0; step < 50; ++step) s.advance(1e-3);
  EXPECT_EQ(s.fault(), Fault::none);
  return angular_momentum(s.particles(), inertia) / before;
}

/// D_p = h²/4 for quadratic splines and h²/3 for cubic ones; a mean over boxes of width l adds l²/12.
TEST(Apic, KeepsAngularMomentumWherePicLosesIt) {
  for (const std::string_view integrator : {"usl", "usf", "usavg", "usl+", "usavg+"})
    EXPECT_NEAR(spin_left<BSpline2>(Apic{}, 0.01 / 4, integrator), 1, 1e-12) << integrator;
  EXPECT_NEAR(spin_left<BSpline3>(Apic{}, 0.01 / 3), 1, 1e-12);
  EXPECT_NEAR(spin_left<B2Gimp>(Apic{}, 0.01 / 4 + 0.0025 / 12), 1, 1e-12);
  EXPECT_LT(spin_left<BSpline2>(Pic{}, 0), 0.5);
}

}  // namespace mpmvv::solver::apic_test
