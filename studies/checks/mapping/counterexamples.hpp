#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/checks/basis_function.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/matrix_product.hpp"
#include "studies/checks/mapping/shape_properties.hpp"
#include "studies/checks/mapping/sum_properties.hpp"

/// The smallest bodies that settle a claim, each with the number that settles it.
namespace mpmvv::checks::mapping {

/// Returns a line of 20 unit cells with particles of the given widths side by side, which begin at `lower`.
inline MappedBody<1> line_of(double lower, const std::vector<double>& widths, const Weighting& weighting) {
  return MappedBody<1>({solver::Vec<1>::Zero(), solver::Vec<1>::Ones(), {20}}, tiling_of_widths(lower, widths),
                       weighting);
}

/// (i) Returns the largest |Φ_p(x_q) - δ_pq| of one particle on each node, lumped. Then v_ip = δ_ip and Φ_p = N_p.
inline double interpolation_of_particles_on_nodes() {
  const auto body = line_of(3.5, std::vector<double>(12, 1.0), dirac);
  return interpolation(Subject<1>(body, MassKind::lumped));
}

/// (i) Returns the largest |Φ_p(x_q) - δ_pq| of two particles in one cell. The mass matrix is their quadrature, so v is
/// square and ψ = v⁻ᵀ.
inline double interpolation_of_two_particles() {
  const auto body = line_of(5, {0.5, 0.5}, dirac);
  return interpolation(Subject<1>(body, MassKind::quadrature));
}

/// (vi) Returns the shape difference of two particles of one size, each in the middle of its cell, whose neighbours
/// differ in size. The boxes are 2, 2, 3, 1, 2 and 2 sixths of a cell wide, which repeats every two cells; lumped.
inline double shape_difference_by_neighbours(const Weighting& weighting) {
  std::vector<double> widths;
  for (int k = 0; k < 5; ++k)
    for (const double sixths : {2, 2, 3, 1, 2, 2}) widths.push_back(sixths / 6);
  const auto body = line_of(5, widths, weighting);
  const Subject<1> s(body, MassKind::lumped);
  constexpr std::size_t p = 13, q = 16;
  const auto offsets = symmetric_offsets(body.grid());
  return largest_of((s.around(p, offsets) - s.around(q, offsets)).cwiseAbs()) / s.peak(p);
}

/// (ix) Returns the valley of Φ_p on the diagonal of a cell. The particle is in the middle of the cell, and particles a
/// hundred times as heavy sit on the two corners beside the diagonal; lumped. ψ is 1 on the corners that no other
/// particle reaches and 0.0025 on the others.
inline double valley_between_corners() {
  const OverlayGrid<2> grid{solver::Vec<2>::Zero(), solver::Vec<2>::Ones(), {5, 5}};
  const NodalBasis<2> nodal(solver::Linear{}, grid);
  const Eigen::VectorXd M{{1, 100, 100}};
  const auto basis = ParticleBasis::lumped(nodal.weights({{2.5, 2.5}, {3, 2}, {2, 3}}), M);
  Points<2> diagonal;
  for (int k = 0; k <= 20; ++k) diagonal.emplace_back(2 + k / 20.0, 2 + k / 20.0);
  const Eigen::RowVectorXd phi = basis.at(nodal.weights(diagonal)).row(0);
  return valley_of({phi.begin(), phi.end()});
}

/// Returns the hat functions of a line of nodes at any places, at the points x: nodes x points.
inline Eigen::MatrixXd hats(const std::vector<double>& nodes, const std::vector<double>& x) {
  Eigen::MatrixXd N =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(nodes.size()), static_cast<Eigen::Index>(x.size()));
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto right = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x[k]);
    const auto i = static_cast<Eigen::Index>(right - nodes.begin()), column = static_cast<Eigen::Index>(k);
    N(i, column) = (x[k] - *(right - 1)) / (*right - *(right - 1));
    N(i - 1, column) = 1 - N(i, column);
  }
  return N;
}

/// (xiii) Returns the largest change of Φ_p on material points when a grid carries its particles and points through a
/// deformation that is not homogeneous, as in every step of MPM; lumped, Dirac.
inline double change_carried_by_grid() {
  constexpr int cells = 6;
  std::vector<double> nodes, moved_nodes, particles, points;
  for (int i = 0; i <= cells; ++i) {
    nodes.push_back(i);
    moved_nodes.push_back(i + 0.3 * std::sin(2 * std::numbers::pi * i / cells + 0.5));
  }
  Random random(1613);
  for (int p = 0; p < 3 * cells; ++p) particles.push_back((p + random.uniform(0.1, 0.9)) / 3);
  for (int k = 0; k <= 24 * cells; ++k) points.push_back(k / 24.0);
  const auto carried = [&](const std::vector<double>& x) {
    const Eigen::RowVectorXd at = Eigen::RowVectorXd::Map(moved_nodes.data(), cells + 1) * hats(nodes, x);
    return std::vector<double>(at.begin(), at.end());
  };
  const auto phi = [](const std::vector<double>& grid, const std::vector<double>& x_p, const std::vector<double>& x) {
    const auto M = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(x_p.size()));
    return matrix_product(ParticleBasis::lumped(hats(grid, x_p), M).psi().transpose(), hats(grid, x));
  };
  return largest_of((phi(moved_nodes, carried(particles), carried(points)) - phi(nodes, particles, points)).cwiseAbs());
}

}  // namespace mpmvv::checks::mapping
