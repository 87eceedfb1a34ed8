#pragma once
#include <algorithm>

#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/subject.hpp"

/// Properties of sums over particles, and bounds. Each function returns a number that measures by how much a subject
/// departs from a property of B.
namespace mpmvv::checks::mapping {

/// Returns Σ_i N_i over the nodes that take part, at the lattice's points.
template <int D>
Eigen::RowVectorXd coverage(const Subject<D>& s) {
  Eigen::RowVectorXd takes_part(s.basis().psi().rows());
  for (Eigen::Index i = 0; i < takes_part.size(); ++i) takes_part[i] = s.basis().reaches(i) ? 1 : 0;
  return takes_part * s.N();
}

/// Returns the largest of the `values` at the lattice's points that lie in the body, at least `depth` cells from its
/// faces. With `covered` only points count where every node takes part.
template <int D>
double largest_in_body(const Subject<D>& s, const Eigen::RowVectorXd& values, bool covered, double depth) {
  const Eigen::RowVectorXd cover = coverage(s);
  const solver::Vec<D> margin = depth * s.body().grid().h;
  double worst = 0;
  for (const Eigen::Index k : s.in_body())
    if (s.body().tiling().contains(s.lattice().points()[static_cast<std::size_t>(k)], margin) &&
        (!covered || cover[k] > 1 - 1e-9))
      keep_larger(worst, values[k]);
  return worst;
}

/// Returns |Σ_p x_p Φ_p - x| / h at the lattice's points, the largest component.
template <int D>
Eigen::RowVectorXd position_misfits(const Subject<D>& s) {
  Eigen::RowVectorXd misfits = Eigen::RowVectorXd::Zero(s.phi().cols());
  for (int d = 0; d < D; ++d) {
    Eigen::RowVectorXd x_p(s.phi().rows()), x(s.phi().cols());
    for (Eigen::Index p = 0; p < x_p.size(); ++p) x_p[p] = s.body().tiling().x[static_cast<std::size_t>(p)][d];
    for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = s.lattice().points()[static_cast<std::size_t>(k)][d];
    misfits = misfits.cwiseMax((x_p * s.phi() - x).cwiseAbs() / s.body().grid().h[d]);
  }
  return misfits;
}

/// (i) Returns the largest |Φ_p(x_q) - δ_pq|.
template <int D>
double interpolation(const Subject<D>& s) {
  const Eigen::MatrixXd at_particles = s.basis().at(s.body().field().weights(s.body().tiling().x));
  return largest_of((at_particles - Eigen::MatrixXd::Identity(at_particles.rows(), at_particles.cols())).cwiseAbs());
}

/// (i) Returns the root mean square over interior particles of ∫Φ_p dV / V_p - 1, over that of point-to-point
/// interpolation. `no_meaning` but in one dimension with boxes that differ (interpolation is exact on equal ones).
template <int D>
double integrals_over_interpolation(const Subject<D>& s) {
  const auto& tiling = s.body().tiling();
  if (D > 1 || tiling.boxes_are_alike()) return no_meaning;
  double mapped = 0, interpolated = 0;
  for (const std::size_t p : s.interior()) {
    const double V = tiling.width[p][0], gaps = tiling.x[p + 1][0] - tiling.x[p - 1][0];
    const double integral = s.body().grid().h[0] * s.basis().psi().col(static_cast<Eigen::Index>(p)).sum();
    mapped += (integral / V - 1) * (integral / V - 1);
    interpolated += (gaps / 2 / V - 1) * (gaps / 2 / V - 1);
  }
  return std::sqrt(mapped / interpolated);
}

/// (ii) Returns the largest |Σ_p Φ_p - 1| in the body where every node takes part.
template <int D>
double unity(const Subject<D>& s) {
  return largest_in_body(s, (s.phi().colwise().sum().array() - 1).abs().matrix(), true, 0);
}

/// (ii) Returns `unity` with GIMP weights, `no_meaning` with others.
template <int D>
double unity_of_gimp(const Subject<D>& s) {
  return std::holds_alternative<solver::Gimp>(s.body().weighting().particle) ? unity(s) : no_meaning;
}

/// (ii) Returns the largest |Σ_p Φ_p - 1| in the whole body.
template <int D>
double unity_in_body(const Subject<D>& s) {
  return largest_in_body(s, (s.phi().colwise().sum().array() - 1).abs().matrix(), false, 0);
}

/// (iii) Returns the largest |Σ_p x_p Φ_p - x| / h in the body where every node takes part.
template <int D>
double linear_completeness(const Subject<D>& s) {
  return largest_in_body(s, position_misfits(s), true, 0);
}

/// (iii) Returns the same error at least three cells from the faces of the body; `no_meaning` unless boxes are alike.
template <int D>
double linear_completeness_inside(const Subject<D>& s) {
  return s.body().tiling().boxes_are_alike() ? largest_in_body(s, position_misfits(s), true, 3) : no_meaning;
}

/// (viii) Returns the largest excess of Φ_p over 1 or of 0 over Φ_p.
template <int D>
double positivity(const Subject<D>& s) {
  double excess = 0;
  keep_larger(excess, largest_of(s.phi()) - 1);
  keep_larger(excess, largest_of(-s.phi()));
  return excess;
}

}  // namespace mpmvv::checks::mapping
