#pragma once

#include "studies/checks/basis_function.hpp"
#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/subject.hpp"

/// Properties of the particle basis as a field. Each function returns a number that measures by how much a subject
/// departs from a property.
namespace mpmvv::checks::mapping {

/// Returns random values in [-1, 1] for the particles, the same on every machine.
inline Eigen::VectorXd random_data(Eigen::Index count) {
  Random random(16);
  Eigen::VectorXd f(count);
  for (double& value : f) value = random.uniform(-1, 1);
  return f;
}

/// Returns one point inside each piece of the nodal functions, moved by `shift` cells along an axis. Pieces are half a
/// cell wide along each axis. Those in the outermost cells are left out.
template <int D>
Points<D> points_inside_pieces(const OverlayGrid<D>& grid, int axis, double shift) {
  constexpr double place[] = {0.29, 0.21};
  const auto pieces = [&grid](int d) { return 2 * grid.cells[d] - 4; };
  Points<D> points;
  for (int k = 0; k < (D == 1 ? pieces(0) : pieces(0) * pieces(D - 1)); ++k) {
    const solver::Index<2> piece{k % pieces(0), k / pieces(0)};
    solver::Vec<D> at;
    for (int d = 0; d < D; ++d) at[d] = 1 + 0.5 * piece[static_cast<std::size_t>(d)] + place[d];
    at[axis] += shift;
    points.push_back(grid.lower + at.cwiseProduct(grid.h));
  }
  return points;
}

/// Returns the largest difference of Σ_i F_i N_i and Σ_p f_p Φ_p, B (16.26) to (16.31), over the largest |Φ_p|. The f_p
/// are random in [-1, 1].
template <int D>
double two_fields(const Subject<D>& s) {
  const Eigen::VectorXd f = random_data(s.body().M().size());
  const Eigen::MatrixXd F = nodal_values(s.body().mass_matrix(s.mass()), s.body().v(), s.body().M(), f);
  return largest_of((F.transpose() * s.N() - f.transpose() * s.phi()).cwiseAbs()) / s.largest();
}

/// (iv) Returns the largest difference of a central difference and h Σ_i ψ_ip ∇N_i inside the pieces of the nodal
/// functions, over the largest |Φ_p|.
template <int D>
double piecewise_gradient(const Subject<D>& s) {
  constexpr double step = 1e-3;  // in cells; the pieces are at most quadratic, so only round-off is left
  double worst = 0;
  for (int axis = 0; axis < D; ++axis) {
    const auto field_at = [&](double shift) {
      return s.basis().at(s.body().field().weights(points_inside_pieces(s.body().grid(), axis, shift)));
    };
    const auto gradients = s.body().field().gradients(axis, points_inside_pieces(s.body().grid(), axis, 0));
    const Eigen::MatrixXd exact = s.body().grid().h[axis] * s.basis().at(gradients);
    keep_larger(worst, largest_of(((field_at(step) - field_at(-step)) / (2 * step) - exact).cwiseAbs()));
  }
  return worst / s.largest();
}

/// (xiv) Returns the largest difference of Φ_p and the field of data that are 1 on particle p and 0 on all others, over
/// the largest |Φ_p|.
template <int D>
double field_of_one(const Subject<D>& s) {
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Identity(s.phi().rows(), s.phi().rows());
  const Eigen::MatrixXd F = nodal_values(s.body().mass_matrix(s.mass()), s.body().v(), s.body().M(), ones);
  return largest_of((F.transpose() * s.N() - s.phi()).cwiseAbs()) / s.largest();
}

}  // namespace mpmvv::checks::mapping
