#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "solver/integrator/integrators.hpp"
#include "solver/velocity_update/affine.hpp"
#include "tests/solver/each_basis.hpp"
#include "tests/solver/scenes.hpp"

/// Scenes that the solver would compute wrongly, beside those of images_test.cpp and wall_test.cpp.
namespace mpmvv::solver::refused_scenes_test {

/// Why the scene is refused; empty where it is not.
template <int D>
std::string refusal(const Scene<D>& scene) {
  try {
    Mpm<D> mpm(scene);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

class RefusedScenes : public WithEachBasis {};
INSTANTIATE_TEST_SUITE_P(, RefusedScenes, every_basis(), word_in_name);

TEST_P(RefusedScenes, HaveImagesOfGhostsThatTheBasisLacks) {
  for (const AnyBoundary& boundary : {AnyBoundary{Periodic{}}, AnyBoundary{Mirror{}}})
    for (const std::size_t face : {0U, 3U}) {
      Scene<2> scene = full_scene<2>(basis, 12, 2, Free{});
      scene.boundary[face] = scene.boundary[face ^ 1U] = boundary;
      EXPECT_EQ(refusal(scene), has_open_knots ? "a periodic or mirror face of a basis without ghost nodes" : "");
    }
}

/// The body continued for ever fills each cell, and so each node.
TEST_P(RefusedScenes, HaveMirrorsThatReachTheOtherFace) {
  if (has_open_knots) GTEST_SKIP() << "an open-knot basis has no mirror";
  const int enough = ghosts_of(basis) - reach(width_of(basis)) + 1;
  ASSERT_GE(enough, 3);
  for (int cells = 1; cells < enough; ++cells)
    EXPECT_EQ(refusal(full_scene<1>(basis, cells, 4, Mirror{})), "a mirror on an axis of too few cells") << cells;
  const Scene<1> scene = full_scene<1>(basis, enough, 4, Mirror{});
  Mpm<1> mpm(scene);
  mpm.map_acceleration();
  for (int i = 0; i <= enough; ++i)
    EXPECT_NEAR(mpm.grid().m(static_cast<std::size_t>(mpm.grid().node({i}))), scene.h, 1e-14) << i;
}

TEST_P(RefusedScenes, HaveAnAffineFieldWithoutTheWeightsForIt) {
  Scene<1> scene = full_scene<1>(basis, 12, 2, Free{});
  scene.velocity_update = Apic{};
  const bool has_weights = std::visit([]<class B>(const B&) { return has_affine_fields<B>; }, basis);
  EXPECT_EQ(refusal(scene), has_weights ? "" : "an affine velocity field on a basis without the weights for it");
}

TEST(RefusedScene, HasAHistoryInStages) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2);
  scene.material = MieGruneisen{.bulk_modulus = 1e4, .gamma = 1};
  EXPECT_EQ(refusal(scene), "");
  scene.integrator = "rk4";
  EXPECT_EQ(refusal(scene), "a material with a history in stages");
}

TEST(RefusedScene, HasAxesWithoutCellsOrPeriodicOnOneFace) {
  Scene<2> scene = full_scene<2>(BSpline2{}, 8, 2, Free{});
  scene.boundary[2] = Periodic{};
  EXPECT_EQ(refusal(scene), "an axis that is periodic on one face only");
  scene.boundary[2] = Free{};
  scene.cells[1] = 0;
  EXPECT_EQ(refusal(scene), "an axis without cells");
  scene.cells[1] = 8, scene.h = 0;
  EXPECT_EQ(refusal(scene), "cells without a width");
  scene.h = 1, scene.lower[1] = std::nan("");
  EXPECT_EQ(refusal(scene), "a domain without a lower corner");
}

TEST(RefusedScene, HasPlanesOfSymmetryThatReachTheOtherFace) {
  for (const int cells : {1, 2})
    EXPECT_EQ(refusal(full_scene<1>(BSpline2{}, cells, 4, Symmetry{})),
              "a plane of symmetry on an axis of too few cells");
  EXPECT_EQ(refusal(full_scene<1>(BSpline2{}, 3, 4, Symmetry{})), "");
}

TEST(RefusedScene, HasNumbersOutOfTheirRange) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2);
  scene.basis = UGimp{1.5};
  EXPECT_EQ(refusal(scene), "a smoothing length that is not in (0, 1]");
  scene.basis = UGimp{1};
  EXPECT_EQ(refusal(scene), "");
  scene.velocity_update = Fmpm(2, 0);
  EXPECT_EQ(refusal(scene), "an expanded inverse every 0 steps");
  for (const AnyVelocityUpdate& update : {AnyVelocityUpdate{Fmpm(0)}, AnyVelocityUpdate{Xpic(0)}}) {
    scene.velocity_update = update;
    EXPECT_EQ(refusal(scene), "an expanded inverse without terms");
  }
}

TEST(RefusedScene, HasAConsistentMassThatItsVelocityUpdateDoesNotTake) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2);
  scene.consistent_mass = ConsistentMassSettings{};
  EXPECT_EQ(refusal(scene), "");
  scene.velocity_update = Xpic(4);
  EXPECT_EQ(refusal(scene), "the consistent mass with a velocity update that lumped masses define");
}

TEST(RefusedScene, HasDifferencesWhereNoneCanBeTaken) {
  Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2, Symmetry{});
  scene.difference_acceleration = true;
  EXPECT_EQ(refusal(scene), "");
  for (const char* integrator : {"rk4", "uvf"}) {
    scene.integrator = integrator;
    EXPECT_EQ(refusal(scene), "differences for accelerations at walls with an integrator that has none to take");
  }
  scene.integrator = "usl", scene.velocity_update = Pic{};
  EXPECT_EQ(refusal(scene), "differences for accelerations at walls, of which nothing is made");
}

TEST(RefusedScene, HasAMovingWallThatItsSchemeDoesNotTake) {
  struct AtRest final : WallMotion {
    double position(double) const override { return 0; }
    double velocity(double) const override { return 0; }
    double gradient(double) const override { return 0; }
  } const at_rest;
  Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2, Free{});
  scene.boundary[0] = Wall{.motion = &at_rest};
  EXPECT_EQ(refusal(scene), "");
  for (const double depth : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    std::get<Wall>(scene.boundary[0]).depth = depth;
    EXPECT_EQ(refusal(scene), "a wall whose depth is not 0 or more");
  }
  std::get<Wall>(scene.boundary[0]).depth = 1;
  for (const char* integrator : {"rk4", "cd", "uvf"}) {
    scene.integrator = integrator;
    EXPECT_EQ(refusal(scene), "a moving wall with an integrator whose steps are staggered or staged") << integrator;
  }
  scene.integrator = "usl", scene.consistent_mass = ConsistentMassSettings{};
  EXPECT_EQ(refusal(scene), "a moving wall with the consistent mass and a velocity update that adds accelerations");
  scene.velocity_update = Fmpm(2);
  EXPECT_EQ(refusal(scene), "");
}

/// `uvf` and `rk4` write particle velocities themselves, and the velocities of `cd` are half a step behind.
TEST(RefusedScene, HasAVelocityUpdateThatItsIntegratorDoesNotMake) {
  const char* const refused =
      "a velocity update other than flip, first order, with an integrator whose steps are staggered or staged";
  for (const Integrator& integrator : integrators())
    for (const AnyVelocityUpdate& update :
         {AnyVelocityUpdate{Flip{FlipPosition::second_order}}, AnyVelocityUpdate{Flip{FlipPosition::particle}},
          AnyVelocityUpdate{Pic{}}, AnyVelocityUpdate{Apic{}}, AnyVelocityUpdate{Xpic(2)},
          AnyVelocityUpdate{Fmpm(2)}}) {
      Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2);
      scene.integrator = integrator.word;
      EXPECT_EQ(refusal(scene), "");
      scene.velocity_update = update;
      EXPECT_EQ(refusal(scene), integrator.has_whole_steps() ? "" : refused) << integrator.word;
    }
}

TEST(RefusedScene, AsksForMoreThanStagesMake) {
  for (const char* integrator : {"usl", "rk4"}) {
    const std::string refused =
        integrator == std::string("usl") ? "" : "exponential deformation or a half start in stages";
    Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2);
    scene.integrator = integrator, scene.half_start = true;
    EXPECT_EQ(refusal(scene), refused);
    scene.half_start = false, scene.deformation = Deformation::exponential;
    EXPECT_EQ(refusal(scene), refused);
  }
}

TEST(RefusedScene, HasParticlesThatLackAField) {
  const Scene<2> sound = full_scene<2>(CpGimp{}, 8, 2);
  EXPECT_EQ(refusal(sound), "");
  const auto refusal_with = [&sound](auto change) {
    Scene<2> scene = sound;
    change(scene.particles);
    return refusal(scene);
  };
  const char* const refused = "particles whose fields have different lengths";
  EXPECT_EQ(refusal_with([](Particles<2>& particles) { particles.id.pop_back(); }), refused);
  EXPECT_EQ(refusal_with([](Particles<2>& particles) { particles.v.pop_back(); }), refused);
  EXPECT_EQ(refusal_with([](Particles<2>& particles) { particles.F.pop_back(); }), refused);
  EXPECT_EQ(refusal_with([](Particles<2>& particles) { particles.m.pop_back(); }), refused);
  EXPECT_EQ(refusal_with([](Particles<2>& particles) { particles.V0.pop_back(); }), refused);
  EXPECT_EQ(refusal_with([](Particles<2>& particles) { particles.X.resize(1); }), refused);
  EXPECT_EQ(refusal_with([](Particles<2>& particles) { particles.l.pop_back(); }),
            "particles without the widths that the basis takes");
  EXPECT_EQ(refusal_with([](Particles<2>& particles) { particles.l0.clear(); }),
            "particles without the widths at rest that the basis takes");
}

TEST(RefusedScene, HasWidthsThatFollowTheDeformationWhereTheBasisTakesThoseAtRest) {
  Scene<1> scene = full_scene<1>(Gimp{}, 8, 2);
  EXPECT_EQ(refusal(scene), "");
  scene.particles.l0 = scene.particles.l;
  EXPECT_EQ(refusal(scene), "widths that follow F with a basis whose widths do not");
}

/// Widths and domains at rest are kept up to date whatever the basis.
TEST(RefusedScene, HasWidthsOrDomainsThatDoNotFitTheirs) {
  Scene<2> scene = full_scene<2>(BSpline2{}, 8, 2);
  const std::size_t n = scene.particles.size();
  scene.particles.l0.assign(n, Vec<2>::Constant(0.5));
  EXPECT_EQ(refusal(scene), "widths at rest without widths");
  scene.particles.l = scene.particles.l0;
  EXPECT_EQ(refusal(scene), "");
  scene.particles.R0.assign(n, Mat<2>::Identity());
  EXPECT_EQ(refusal(scene), "domains at rest without domains");
  scene.particles.R.assign(n - 1, Mat<2>::Identity());
  EXPECT_EQ(refusal(scene), "particles whose fields have different lengths");
}

/// A scene may go on with the particles of another one, which had fields that it does not have.
TEST(Mpm, LeavesFieldsOfAnotherSchemeOut) {
  Scene<2> scene = full_scene<2>(BSpline2{}, 8, 2);
  scene.velocity_update = Apic{};
  Mpm<2> affine(scene);
  ASSERT_EQ(affine.advance(1e-4, 5), 5);
  scene.velocity_update = Flip{};
  Scene<2> with_more = scene;
  with_more.particles = affine.particles();
  scene.particles = affine.particles();
  scene.particles.C.clear();
  Mpm<2> flip(scene), from_affine(with_more);
  flip.advance(1e-4, 5), from_affine.advance(1e-4, 5);
  EXPECT_TRUE(from_affine.particles().C.empty());
  EXPECT_EQ(from_affine.kinetic_energy(), flip.kinetic_energy());
}

TEST(RefusedScene, HasParticlesWithoutAMassAVolumeOrAnIdOfTheirOwn) {
  const auto refusal_with = [](auto change) {
    Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2);
    change(scene.particles);
    return refusal(scene);
  };
  for (const double amount : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_EQ(refusal_with([=](Particles<1>& particles) { particles.m[3] = amount; }), "a particle without a mass");
    EXPECT_EQ(refusal_with([=](Particles<1>& particles) { particles.V0[3] = amount; }), "a particle without a volume");
  }
  const char* const refused = "particles whose ids are not 0, 1, ... in some order";
  EXPECT_EQ(refusal_with([](Particles<1>& particles) { particles.id[3] = 4; }), refused);
  EXPECT_EQ(refusal_with([](Particles<1>& particles) { particles.id[3] = 1'000; }), refused);
  EXPECT_EQ(refusal_with([](Particles<1>& particles) { std::swap(particles.id[3], particles.id[5]); }), "");
}

TEST(RefusedScene, HasALoadOnAParticleThatIsNotThere) {
  struct OnePart final : SurfaceLoad<2> {
    Part part{};
    std::span<const Part> parts() const override { return {&part, 1}; }
    void forces(double, Vec<2>* f) const override { f->setZero(); }
  } load;
  Scene<2> scene = full_scene<2>(BSpline2{}, 8, 2);
  scene.surface_load = &load;
  EXPECT_EQ(refusal(scene), "");
  load.part.particle = static_cast<std::uint32_t>(scene.particles.size());
  EXPECT_EQ(refusal(scene), "a load on the surface of a particle that is not there");
}

TEST(RefusedScene, HasSettingsOfItsMassesOutOfTheirRange) {
  const auto refusal_with = [](ConsistentMassSettings settings) {
    Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2);
    scene.consistent_mass = settings;
    return refusal(scene);
  };
  EXPECT_EQ(refusal_with({.lumped_share = 1}), "");
  for (const double share : {0.0, 1.1, std::nan("")})
    EXPECT_EQ(refusal_with({.lumped_share = share}), "a lumped share that is not in [1e-12, 1]");
  for (const double tolerance : {0.0, 1.0, std::nan("")})
    EXPECT_EQ(refusal_with({.tolerance = tolerance}), "a tolerance that is not in [1e-14, 1)");
  EXPECT_EQ(refusal_with({.covered = -1}), "a fraction of covered mass that is not in [0, 1]");
  for (const double cutoff : {-1e-9, 1.0, std::nan("")}) {
    Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2);
    scene.mass_cutoff = cutoff;
    EXPECT_EQ(refusal(scene), "a mass cutoff that is not in [0, 1)");
  }
}

TEST(RefusedTimeStep, IsNotAboveZero) {
  Mpm<1> mpm(full_scene<1>(BSpline2{}, 8, 2));
  for (const double dt : {0.0, -1e-3, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(mpm.step(dt), std::invalid_argument) << dt;
    EXPECT_THROW(mpm.advance(dt, 3), std::invalid_argument) << dt;
  }
  EXPECT_TRUE(mpm.step(1e-3));
}

TEST(RefusedScene, HasMoreNodesThanIndicesCount) {
  EXPECT_THROW(Grid<2>(Vec<2>::Zero(), 1, {50'000, 50'000}, 1, 2), std::length_error);
  EXPECT_THROW(Grid<3>(Vec<3>::Zero(), 1, {2'000'000'000, 2'000'000'000, 2'000'000'000}, 1, 2), std::length_error);
  EXPECT_THROW(Grid<1>(Vec<1>::Zero(), 1, {2'147'483'645}, 1, 2), std::length_error);
}

}  // namespace mpmvv::solver::refused_scenes_test
