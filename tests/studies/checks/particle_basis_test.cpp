#include "studies/checks/mapping/particle_basis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "studies/checks/mapping/cases.hpp"
#include "studies/checks/mapping/shape_properties.hpp"

namespace mpmvv::checks::particle_basis_test {

using namespace mapping;

constexpr double round_off = 1e-14;

/// Two particles at 1/4 and 3/4 of one cell, linear basis: v_ip at its two nodes.
Eigen::Matrix2d weights_of_two() {
  return Eigen::Matrix2d{{0.75, 0.25}, {0.25, 0.75}};
}

/// m_i = Σ_p M_p v_ip = (3/4 + 3/4, 1/4 + 9/4), B (16.31).
TEST(ParticleBasis, LumpedOfTwoParticlesByHand) {
  const auto basis = ParticleBasis::lumped(weights_of_two(), Eigen::Vector2d(1, 3));
  EXPECT_LT((basis.psi() - Eigen::Matrix2d{{0.5, 0.5}, {0.1, 0.9}}).norm(), round_off);
}

/// The quadrature's matrix v M vᵀ with square v: ψ = v⁻ᵀ whatever the masses.
TEST(ParticleBasis, QuadratureOfTwoParticlesByHand) {
  const Eigen::Matrix2d v = weights_of_two();
  const Eigen::Vector2d M(1, 3);
  const auto basis = ParticleBasis::consistent(v * M.asDiagonal() * v.transpose(), v, M);
  EXPECT_LT((basis.psi() - Eigen::Matrix2d{{1.5, -0.5}, {-0.5, 1.5}}).norm(), round_off);
}

/// m = (1/3, 1/6; 1/6, 1/3), B (16.11), so m⁻¹ = (4, -2; -2, 4), times v M = (3/8, 1/8; 1/8, 3/8).
TEST(ParticleBasis, ExactMassOfTwoParticlesByHand) {
  const MappedBody<1> body({solver::Vec<1>(0), solver::Vec<1>(1), {10}}, tiling_of_widths(5, {0.5, 0.5}), dirac);
  const Eigen::MatrixXd m = body.mass_matrix(MassKind::exact);
  EXPECT_NEAR(m(5, 5), 1.0 / 3, round_off);
  EXPECT_NEAR(m(5, 6), 1.0 / 6, round_off);
  EXPECT_LT((m - body.mass_matrix(MassKind::piecewise)).norm(), round_off);
  const Eigen::MatrixXd psi = body.basis(MassKind::exact).psi().middleRows(5, 2);
  EXPECT_LT((psi - Eigen::Matrix2d{{1.25, -0.25}, {-0.25, 1.25}}).norm(), round_off);
  EXPECT_LT((body.basis(MassKind::lumped).psi().middleRows(5, 2) - weights_of_two()).norm(), round_off);
}

/// One particle cannot tell the two nodes of its cell apart, but is interpolated: Φ(x_p) = 1.
TEST(ParticleBasis, SingularMassIsSolvedAsFarAsItGoes) {
  const Eigen::MatrixXd v = Eigen::Vector2d(0.25, 0.75);
  const auto basis = ParticleBasis::consistent(v * v.transpose(), v, Eigen::VectorXd::Ones(1));
  EXPECT_NEAR((v.transpose() * basis.psi())(0, 0), 1, round_off);
}

TEST(ParticleBasis, NodesWithoutMassTakeNoPart) {
  const Eigen::MatrixXd v{{1, 0.5}, {0, 0}, {0, 0.5}};
  const Eigen::Vector2d M(1, 1);
  const auto lumped = ParticleBasis::lumped(v, M);
  const auto consistent = ParticleBasis::consistent(v * v.transpose(), v, M);
  for (const auto* basis : {&lumped, &consistent}) {
    EXPECT_TRUE(basis->reaches(0));
    EXPECT_FALSE(basis->reaches(1));
  }
}

/// (16.21): rows of the lumped and of the quadrature's matrix have the same sums; all matrices have the body's mass;
/// with the lumped one Σ_p ψ_ip = 1.
template <int D>
void expect_masses(const Weighting& weighting, Placement placement) {
  const auto tiling = BlockOfParticles<D>::tiling(placement);
  const MappedBody<D> body(BlockOfParticles<D>::grid(), tiling, weighting);
  const double mass = tiling.masses().sum();
  const double middle = tiling.density((tiling.lower + tiling.upper) / 2);
  EXPECT_NEAR(mass, middle * std::pow(BlockOfParticles<D>::cells, D), 1e-10) << "of a linear density";
  for (const MassKind kind : mass_kinds) EXPECT_NEAR(body.mass_matrix(kind).sum(), mass, 1e-10);
  const Eigen::VectorXd lumped = body.mass_matrix(MassKind::lumped).diagonal();
  EXPECT_LT((body.mass_matrix(MassKind::quadrature).rowwise().sum() - lumped).norm(), 1e-12);
  const ParticleBasis basis = body.basis(MassKind::lumped);
  for (Eigen::Index i = 0; i < lumped.size(); ++i)
    EXPECT_NEAR(basis.psi().row(i).sum(), basis.reaches(i) ? 1 : 0, round_off);
}

TEST(MappedBody, Masses) {
  for (const Weighting& weighting : weightings)
    for (const Placement placement : placements) expect_masses<1>(weighting, placement);
  expect_masses<2>(gimp, Placement::random);
}

/// GIMP weights are averages of the linear functions over the boxes, B (16.16), here by the boxes' Gauss points.
TEST(MappedBody, GimpWeightsAreAveragesOverBoxes) {
  const auto tiling = BlockOfParticles<2>::tiling(Placement::random);
  const MappedBody<2> body(BlockOfParticles<2>::grid(), tiling, gimp);
  const DomainQuadrature<2> points(tiling, body.grid());
  const Eigen::MatrixXd N = body.field().weights(points.x);
  Eigen::MatrixXd average = Eigen::MatrixXd::Zero(N.rows(), tiling.size());
  for (std::size_t q = 0; q < points.x.size(); ++q)
    average.col(points.particle[q]) += points.dV[q] * N.col(static_cast<Eigen::Index>(q));
  average = average * tiling.volumes().cwiseInverse().asDiagonal();
  EXPECT_LT((average - body.v()).cwiseAbs().maxCoeff(), 1e-13);
}

/// Σ_j m_ij F_j of the values found is what the particles bring, B (16.17), and a constant stays one.
TEST(MappedBody, NodalValuesSolveTheMapping) {
  const MappedBody<1> body(BlockOfParticles<1>::grid(), BlockOfParticles<1>::tiling(Placement::random), gimp);
  const Eigen::VectorXd f = body.M().array().sin();
  const Eigen::MatrixXd m = body.mass_matrix(MassKind::piecewise);
  const Eigen::VectorXd F = nodal_values(m, body.v(), body.M(), f);
  EXPECT_LT((m * F - body.v() * body.M().cwiseProduct(f)).norm(), 1e-13);
  const Eigen::VectorXd ones = nodal_values(m, body.v(), body.M(), Eigen::VectorXd::Ones(f.size()));
  for (const double value : ones.segment(4, 13)) EXPECT_NEAR(value, 1, 1e-12);
}

TEST(ParticleTiling, MotionKeepsTheMasses) {
  const auto tiling = BlockOfParticles<2>::tiling(Placement::random);
  EXPECT_NEAR(tiling.volumes().sum(), 64, 1e-11);
  EXPECT_FALSE(tiling.boxes_are_alike());
  EXPECT_LT((tiling.translated({0.3, -0.2}).masses() - tiling.masses()).norm(), 1e-12);
  EXPECT_LT((tiling.stretched({1.2, 0.7}, {1, 2}).masses() - tiling.masses()).norm(), 1e-12);
}

TEST(SampleLattice, NumbersAndElements) {
  const SampleLattice<2> lattice(BlockOfParticles<2>::grid());
  for (const std::size_t k : {0, 5, 100, 1234}) EXPECT_EQ(lattice.number(lattice.index(k)), k);
  EXPECT_EQ(lattice.points()[0], solver::Vec<2>(1, 1));
  EXPECT_EQ(lattice.element(0), -1) << "a node";
  const auto inside = static_cast<std::size_t>(lattice.number({SampleLattice<2>::per_cell + 1, 1}));
  EXPECT_EQ(lattice.element(inside), 1) << "second element of the first row";
  EXPECT_EQ(lattice.elements(), 14 * 14);
}

TEST(Valley, IsARiseAfterAFall) {
  EXPECT_EQ(valley_of({1, 0.5, 0.25, 0}), 0);
  EXPECT_EQ(valley_of({1, 0.25, 0.75, 0}), 0.5);
  EXPECT_EQ(valley_of({1, 0, 2}), 1) << "what lies above the start is not counted";
  EXPECT_EQ(valley_of({1, 1.5, 1}), 0);
}

}  // namespace mpmvv::checks::particle_basis_test
