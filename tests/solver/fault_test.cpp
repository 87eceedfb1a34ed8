#include <limits>

#include "tests/numbers.hpp"
#include "tests/solver/each_basis.hpp"
#include "tests/solver/scenes.hpp"
#include "tests/solver/stencils.hpp"

namespace mpmvv::solver::fault_test {

/// Steps until the run reports a fault, then a few more, which do nothing. At one go it must be the same.
template <int D>
std::string fault_of(const Scene<D>& scene, double dt, int steps = 20) {
  Mpm<D> mpm(scene);
  for (int k = 0; k < steps; ++k) {
    if (mpm.step(dt)) continue;
    const std::string fault = mpm.fault();
    for (int more = 0; more < 3; ++more) EXPECT_FALSE(mpm.step(dt));
    EXPECT_EQ(mpm.fault(), fault);
    Mpm<D> at_one_go(scene);
    EXPECT_EQ(at_one_go.advance(dt, steps), k + 1);
    EXPECT_EQ(at_one_go.time(), mpm.time());
    EXPECT_EQ(at_one_go.fault(), fault);
    return fault;
  }
  return "";
}

class Faults : public WithEachBasis {
 protected:
  /// Calls check(scene) with sound scenes of every integrator: the line on one thread and on two, the square on two.
  template <class Check>
  void everywhere(const Check& check) {
    const AnyBoundary boundary = has_open_knots ? AnyBoundary{Dirichlet{}} : Periodic{};
    for (const auto integrator : integrator_words())
      for (const int threads : {1, 2}) {
        const auto prepared = [&](auto scene) {
          set_wave(scene, 1);
          scene.integrator = integrator;
          scene.threads = threads;
          return scene;
        };
        check(prepared(full_scene<1>(basis, 40, 2, boundary)));
        if (threads == 2) check(prepared(full_scene<2>(basis, 17, 2, boundary)));
        if (threads == 1 && integrator == "usl") check(prepared(full_scene<3>(basis, 3, 2, boundary)));
      }
  }
};
INSTANTIATE_TEST_SUITE_P(, Faults, every_basis(), word_in_name);

TEST_P(Faults, SoundRunsHaveNone) {
  everywhere([](const auto& scene) { EXPECT_EQ(fault_of(scene, 0.1 * scene.h / 120), ""); });
}

TEST_P(Faults, NotANumberIsReported) {
  everywhere([](auto scene) {
    scene.particles.v[7][0] = nan;
    EXPECT_NE(fault_of(scene, 0.1 * scene.h / 120, 3), "");
    scene.particles.v[7][0] = 0;
    scene.particles.x[5][0] = nan;
    EXPECT_EQ(fault_of(scene, 0.1 * scene.h / 120, 1), "a particle left the domain");
    scene.particles.x[5][0] = 0.4;
    scene.particles.F[3](0, 0) = nan;
    EXPECT_NE(fault_of(scene, 0.1 * scene.h / 120, 1), "");
  });
}

TEST_P(Faults, LeavingIsReported) {
  everywhere([](auto scene) {
    scene.boundary.fill(Free{});
    for (auto& v : scene.particles.v) v.setConstant(100);
    EXPECT_EQ(fault_of(scene, 0.2 * scene.h / 100), "a particle left the domain");
    for (const double far : {-5.0, 7.0, 1e300, -1e300, std::numeric_limits<double>::infinity()}) {
      scene.particles.x[2][0] = far;
      EXPECT_EQ(fault_of(scene, 0.01 * scene.h / 100), "a particle left the domain") << far;
    }
  });
}

/// What only the next step would find.
TEST_P(Faults, AreFoundInTheStateAfterTheLastStep) {
  everywhere([]<int D>(Scene<D> scene) {
    if (scene.integrator == "rk4") return;  // whose stages look ahead
    scene.boundary.fill(Free{});
    for (auto& v : scene.particles.v) v.setConstant(100);
    const double dt = 0.2 * scene.h / 100;
    Mpm<D> longer(scene), mpm(scene);
    const std::int64_t found = longer.advance(dt, 20);
    EXPECT_EQ(mpm.advance(dt, found - 2), found - 2);
    EXPECT_TRUE(mpm.check()) << mpm.fault();
    EXPECT_TRUE(mpm.step(dt));
    EXPECT_FALSE(mpm.check());
    EXPECT_EQ(mpm.steps(), found - 1);
    EXPECT_EQ(mpm.fault(), longer.fault());
    EXPECT_FALSE(mpm.step(dt));
  });
}

TEST_P(Faults, InversionIsReported) {
  everywhere([](auto scene) {
    scene.particles.F[4] *= -1;
    if (scene.particles.F[4].determinant() > 0) scene.particles.F[4].col(0) *= -1;
    const std::string fault = fault_of(scene, 1e-7, 2);
    EXPECT_TRUE(fault == "det F <= 0 on a particle" || fault == "a particle left the domain") << fault;
  });
}

TEST_P(Faults, TooLongAStepIsReported) {
  everywhere([](const auto& scene) {
    for (const double cfl : {10.0, 100.0, 3000.0}) EXPECT_NE(fault_of(scene, cfl * scene.h / 120, 400), "") << cfl;
  });
}

/// One particle grows too wide, another strays from its slab, so that all are sorted, and a third leaves.
TEST(Fault, IsThatOfAllParticlesWhereTheyAreSorted) {
  for (const int threads : {1, 2}) {
    Scene<1> scene = full_scene<1>(CpGimp{}, 40, 2, Free{});
    scene.material = NeoHookeanLog{1e-9, 1e-9};
    scene.velocity_update = Flip(FlipPosition::particle);
    scene.threads = threads;
    auto& particles = scene.particles;
    const double dt = 1e-3;
    particles.F[3](0, 0) = 3;
    for (const auto& [p, cells] : {std::pair{40U, 14.0}, {78U, 30.0}})
      particles.m[p] = 1e-14, particles.v[p][0] = cells * scene.h / dt;
    EXPECT_EQ(fault_of(scene, dt), "a particle left the domain");
  }
}

TEST(Fault, OutgrownParticlesAreReported) {
  Scene<1> scene = full_scene<1>(CpGimp{}, 8, 1);
  set_wave(scene, 1);
  EXPECT_EQ(fault_of(scene, 0.1 * scene.h / 120), "the width of a particle is not between zero and a cell");
}

TEST(Fault, UnknownIntegratorIsRefused) {
  Scene<1> scene = full_scene<1>(Linear{}, 8, 1);
  scene.integrator = "rk5";
  EXPECT_THROW(Mpm<1>{scene}, std::invalid_argument);
}

TEST(Scenes, ThatCannotBeRunAreRefused) {
  const auto refusal = [](const AnyBasis& basis, const auto& change) -> std::string {
    Scene<2> scene = full_scene<2>(basis, 4, 2);
    change(scene);
    try {
      Mpm<2>{scene};
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(Linear{}, [](Scene<2>& scene) { scene.particles = {}; }), "a scene without particles");
  EXPECT_EQ(refusal(Linear{}, [](Scene<2>& scene) { scene.threads = 0; }), "a scene without threads");
  EXPECT_EQ(refusal(Linear{}, [](Scene<2>& scene) { scene.least_in_slab = 0; }),
            "a scene with slabs without particles");
  for (const AnyBasis& basis : {AnyBasis{Gimp{}}, AnyBasis{CpGimp{}}, AnyBasis{B2Gimp{}}}) {
    EXPECT_EQ(refusal(basis, [](Scene<2>&) {}), "");
    EXPECT_EQ(refusal(basis, [](Scene<2>& scene) { scene.particles.l.pop_back(); }),
              "particles without the widths that the basis takes");
  }
  for (const AnyBasis& basis : {AnyBasis{Cpdi{}}, AnyBasis{B2Cpdi{}}})
    EXPECT_EQ(refusal(basis, [](Scene<2>& scene) { scene.particles.R.pop_back(); }),
              "particles without the domains that the basis takes");
}

}  // namespace mpmvv::solver::fault_test
