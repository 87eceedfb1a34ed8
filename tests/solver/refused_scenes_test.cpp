#include <gmock/gmock.h>

#include <stdexcept>
#include <string>

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

TEST(RefusedScene, HasAMovingWallInStages) {
  struct AtRest final : WallMotion {
    double position(double) const override { return 0; }
    double velocity(double) const override { return 0; }
    double gradient(double) const override { return 0; }
  } const at_rest;
  Scene<1> scene = full_scene<1>(BSpline2{}, 8, 2, Free{});
  scene.boundary[0] = Wall{.motion = &at_rest};
  EXPECT_EQ(refusal(scene), "");
  scene.integrator = "rk4";
  EXPECT_EQ(refusal(scene), "a moving wall in stages");
}

TEST(RefusedScene, HasMoreNodesThanIndicesCount) {
  EXPECT_THROW(Grid<2>(Vec<2>::Zero(), 1, {50'000, 50'000}, 1, 2), std::length_error);
  EXPECT_THROW(Grid<3>(Vec<3>::Zero(), 1, {2'000'000'000, 2'000'000'000, 2'000'000'000}, 1, 2), std::length_error);
  EXPECT_THROW(Grid<1>(Vec<1>::Zero(), 1, {2'147'483'645}, 1, 2), std::length_error);
}

}  // namespace mpmvv::solver::refused_scenes_test
