#include "studies/runs/fill.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numbers>

namespace mpmvv::runs::fill_test {

using problems::Annulus;

using solver::Mat;
using solver::Vec;

template <int D>
std::vector<Voxel<D>> voxels(const problems::Body<D>& body, FillDensity density, bool conforming) {
  std::vector<Voxel<D>> all;
  const PlaceVoxel<D> place = [&all](const Voxel<D>& voxel) { all.push_back(voxel); };
  if (conforming)
    fill_conforming<D>(std::get<Annulus<D>>(body), density, place);
  else
    fill_lattice<D>(body, density, place);
  return all;
}

template <int D>
double total(const std::vector<Voxel<D>>& all) {
  double sum = 0;
  for (const auto& voxel : all) sum += voxel.V;
  return sum;
}

template <class Dimension>
class ConformingFill : public testing::Test {
 public:
  const Annulus<Dimension::value> whole_body{0.4, 1, 1.1};
  const Annulus<Dimension::value> quarter_body{0.4, 1, 1.1, true};
  const FillDensity density{0.125, 2};
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ConformingFill, Dimensions);

TYPED_TEST(ConformingFill, HasTheVolumeOfTheBody) {
  constexpr int D = TypeParam::value;
  for (const auto& annulus : {this->whole_body, this->quarter_body})
    EXPECT_NEAR(total(voxels<D>(annulus, this->density, true)), problems::volume(annulus), 1e-12);
}

TYPED_TEST(ConformingFill, HasTheFirstMomentOfTheQuarter) {
  constexpr int D = TypeParam::value;
  const auto [inner, outer, reach, is_quarter] = this->quarter_body;
  Vec<D> moment = Vec<D>::Zero();
  for (const auto& voxel : voxels<D>(this->quarter_body, this->density, true)) moment += voxel.V * voxel.X;
  const double of_unit_sphere = D == 2 ? 1 : std::numbers::pi / 4;  // ∫ cos θ dΩ over its quarter
  const double exact = of_unit_sphere * (std::pow(outer, D + 1) - std::pow(inner, D + 1)) / (D + 1);
  EXPECT_LT((moment - Vec<D>::Constant(exact)).norm(), 1e-12);
}

TYPED_TEST(ConformingFill, EdgesSpanTheVolumeAndFollowTheRadius) {
  constexpr int D = TypeParam::value;
  for (const auto& voxel : voxels<D>(this->whole_body, this->density, true)) {
    EXPECT_NEAR(voxel.edges.determinant(), voxel.V, 1e-14);
    EXPECT_NEAR(voxel.edges.col(0).normalized().dot(voxel.X.normalized()), 1, 1e-14);
    for (int d = 1; d < D; ++d) {
      EXPECT_NEAR(voxel.edges.col(d).dot(voxel.edges.col(0)), 0, 1e-14);
      EXPECT_GT(voxel.edges.col(d).norm(), 0.5 * voxel.edges.col(0).norm());
      EXPECT_LT(voxel.edges.col(d).norm(), 2.0 * voxel.edges.col(0).norm());
    }
  }
}

TYPED_TEST(ConformingFill, WholeBodyIsTheQuarterAndItsMirrorImages) {
  constexpr int D = TypeParam::value;
  const auto whole = voxels<D>(this->whole_body, this->density, true);
  const auto quarter = voxels<D>(this->quarter_body, this->density, true);
  EXPECT_EQ(whole.size(), quarter.size() << D);
  std::size_t matches = 0;
  for (const auto& voxel : whole) {
    if ((voxel.X.array() < 0).any()) continue;
    for (const auto& one : quarter) matches += (one.X - voxel.X).norm() < 1e-14 ? 1 : 0;
  }
  EXPECT_EQ(matches, quarter.size());
}

TYPED_TEST(ConformingFill, SurfaceIsClosedAndAsLargeAsTheBodys) {
  constexpr int D = TypeParam::value;
  const auto whole = voxels<D>(this->whole_body, this->density, true);
  Vec<D> sum = Vec<D>::Zero();
  double divergence = 0;  // ∮ X · N dA = D V, but for the chord that a patch's middle is taken for
  for (const auto& patch : surface<D>(this->whole_body, this->density)) {
    sum += patch.normal;
    divergence += patch.X.dot(patch.normal);
    EXPECT_LT((patch.X - whole[patch.voxel].X).norm(), this->density.h / this->density.ppc);
    const double outward = patch.X.norm() > 0.7 ? 1 : -1;
    EXPECT_NEAR(patch.normal.normalized().dot(patch.X.normalized()), outward, 1e-14);
  }
  EXPECT_LT(sum.norm(), 1e-12);
  EXPECT_NEAR(divergence / (D * problems::volume(this->whole_body)), 1, 0.01);
}

TEST(LatticeFill, FillsABoxAndItsSurface) {
  const problems::Cuboid<3> box{{1, 2, 3}, 0.5, 0.25};
  const auto all = voxels<3>(box, {0.125, 2}, false);
  EXPECT_EQ(all.size(), 512u);
  EXPECT_NEAR(total(all), volume(box), 1e-15);
  const auto patches = surface<3>(box, {0.125, 2});
  EXPECT_EQ(patches.size(), 6u * 64u);
  Mat<3> moment = Mat<3>::Zero();  // ∮ X ⊗ N dA = V I
  for (const auto& patch : patches) moment += patch.X * patch.normal.transpose();
  EXPECT_LT((moment - 0.125 * Mat<3>::Identity()).norm(), 1e-14);
}

TEST(LatticeFill, LeavesStairsOnAnAnnulus) {
  const Annulus<2> annulus{0.4, 1, 1.1}, quarter{0.4, 1, 1.1, true};
  const auto whole = voxels<2>(annulus, {0.0625, 2}, false);
  EXPECT_EQ(whole.size(), 4 * voxels<2>(quarter, {0.0625, 2}, false).size());
  EXPECT_NEAR(total(whole), volume(annulus), 0.02 * volume(annulus));
  for (const auto& voxel : whole) EXPECT_TRUE(contains(annulus, voxel.X));
}

TEST(Domain, HoldsTheMotionAndPutsNodesOnTheBoxAndTheOrigin) {
  const auto around = domain(Annulus<2>{0.5, 1, 1.1}, 0.125);
  EXPECT_EQ(around.cells, (solver::Index<2>{20, 20}));
  EXPECT_EQ(around.lower, solver::Vec<2>(-1.25, -1.25));
  EXPECT_EQ(domain(Annulus<2>{0.5, 1, 1.1, true}, 0.125).cells, (solver::Index<2>{10, 10}));
  const auto margin = domain(problems::Cuboid<2>{{0, 0}, 1, 0.2}, 0.125);
  EXPECT_EQ(margin.cells, (solver::Index<2>{12, 12}));
  EXPECT_EQ(margin.lower, solver::Vec<2>(-0.25, -0.25));
}

}  // namespace mpmvv::runs::fill_test
