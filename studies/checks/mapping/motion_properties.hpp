#pragma once

#include "studies/checks/extremes.hpp"
#include "studies/checks/mapping/subject.hpp"

/// Properties under motion of particles and grid. Each function returns a number that measures by how much a subject
/// departs from a property of B.
namespace mpmvv::checks::mapping {

/// Returns Φ_p of the moved body at the places to which `place` takes the lattice's points, less Φ_p of `s` at these
/// points: particles x points.
template <int D, class Place>
Eigen::MatrixXd change_at(const Subject<D>& s, const MappedBody<D>& moved, const Place& place) {
  Points<D> points;
  for (const auto& x : s.lattice().points()) points.push_back(place(x));
  return moved.basis(s.mass()).at(moved.field().weights(points)) - s.phi();
}

/// Returns (a, b) in two dimensions, and (a) in one.
template <int D>
solver::Vec<D> vec(double a, double b) {
  solver::Vec<D> v;
  v[D - 1] = b, v[0] = a;
  return v;
}

/// (x) Returns the largest change of Φ_p when grid and particles translate together, over the largest |Φ_p|.
template <int D>
double change_with_grid(const Subject<D>& s) {
  const solver::Vec<D> u = vec<D>(2.345, -0.678);
  auto grid = s.body().grid();
  grid.lower += u;
  const auto moved = s.body().moved(grid, s.body().tiling().translated(u));
  const auto place = [&u](const auto& x) { return solver::Vec<D>(x + u); };
  return largest_of(change_at(s, moved, place).cwiseAbs()) / s.largest();
}

/// (xi) Returns the largest change of the shape of an interior particle, over its peak in the body, when all particles
/// translate by 0.3 cells along the first axis and 0.2 along the second.
template <int D>
double change_on_grid(const Subject<D>& s) {
  const auto& grid = s.body().grid();
  const auto tiling = s.body().tiling().translated(vec<D>(0.3, 0.2).cwiseProduct(grid.h));
  const auto moved_body = s.body().moved(grid, tiling);
  const Subject<D> moved(moved_body, s.mass());
  const auto offsets = symmetric_offsets(grid);
  double worst = 0;
  for (const std::size_t p : s.interior())
    keep_larger(worst, largest_of((moved.around(p, offsets) - s.around(p, offsets)).cwiseAbs()) / s.peak(p));
  return worst;
}

/// Returns the largest variation, over `scale`, of what `integrals(body, basis)` gives for each of the `chosen`
/// particles while all particles translate over a cell.
template <int D, class Integrals>
double largest_variation(const Subject<D>& s, const std::vector<std::size_t>& chosen, const Eigen::VectorXd& scale,
                         const Integrals& integrals) {
  Eigen::VectorXd least = integrals(s.body(), s.basis()), largest = least;
  for (const auto& [body, basis] : s.way()) {
    const Eigen::VectorXd now = integrals(body, basis);
    least = least.cwiseMin(now), largest = largest.cwiseMax(now);
  }
  double worst = 0;
  for (const std::size_t p : chosen) {
    const auto i = static_cast<Eigen::Index>(p);
    keep_larger(worst, (largest[i] - least[i]) / scale[i]);
  }
  return worst;
}

template <int D>
std::vector<std::size_t> all_particles(const Subject<D>& s) {
  std::vector<std::size_t> all;
  for (std::size_t p = 0; p < s.body().tiling().x.size(); ++p) all.push_back(p);
  return all;
}

/// Returns ∫Φ_p dV of each particle. The integral of a nodal function is the volume of a cell.
template <int D>
Eigen::VectorXd integrals_of(const MappedBody<D>& body, const ParticleBasis& basis) {
  return body.grid().h.prod() * basis.psi().colwise().sum().transpose();
}

/// (xii) Returns the largest variation of ∫Φ_p dV / V_p while the particles translate over a cell.
template <int D>
double integral_variation(const Subject<D>& s) {
  return largest_variation(s, all_particles(s), s.body().tiling().volumes(), &integrals_of<D>);
}

/// (xii) Returns the same variation over interior particles; `no_meaning` unless boxes are alike.
template <int D>
double integral_variation_inside(const Subject<D>& s) {
  if (!s.body().tiling().boxes_are_alike()) return no_meaning;
  return largest_variation(s, s.interior(), s.body().tiling().volumes(), &integrals_of<D>);
}

/// (xii) Returns the same variation, over all particles, of Σ_ij m_ij ψ_jp / M_p: the integral weighted with the
/// mapping's own mass.
template <int D>
double weighted_integral_variation(const Subject<D>& s) {
  const auto weighted = [&s](const MappedBody<D>& body, const ParticleBasis& basis) {
    return Eigen::VectorXd(basis.psi().transpose() * body.mass_matrix(s.mass()).rowwise().sum());
  };
  return largest_variation(s, all_particles(s), s.body().M(), weighted);
}

/// (xiii) Returns the largest change of Φ_p on material points when grid and particles stretch together, over the
/// largest |Φ_p|.
template <int D>
double change_stretched_with_grid(const Subject<D>& s) {
  const solver::Vec<D> factor = vec<D>(1.3, 0.7);
  auto grid = s.body().grid();
  grid.lower = grid.lower.cwiseProduct(factor).eval(), grid.h = grid.h.cwiseProduct(factor).eval();
  const auto moved = s.body().moved(grid, s.body().tiling().stretched(factor));
  const auto place = [&factor](const auto& x) { return solver::Vec<D>(x.cwiseProduct(factor)); };
  return largest_of(change_at(s, moved, place).cwiseAbs()) / s.largest();
}

/// (xiii) Returns the largest change of an interior particle's Φ_p on material points of the body, over its peak in the
/// body, when the particles stretch by a tenth on a grid that stays.
template <int D>
double change_stretched_on_grid(const Subject<D>& s) {
  const auto& tiling = s.body().tiling();
  const solver::Vec<D> factor = solver::Vec<D>::Constant(1.1), middle = (tiling.lower + tiling.upper) / 2;
  const auto place = [&](const auto& x) {
    return tiling.contains(x) ? solver::Vec<D>(middle + factor.cwiseProduct(x - middle)) : x;
  };
  const auto change = change_at(s, s.body().moved(s.body().grid(), tiling.stretched(factor, middle)), place);
  double worst = 0;
  for (const std::size_t p : s.interior())
    keep_larger(worst, largest_of(change.row(static_cast<Eigen::Index>(p))(s.in_body()).cwiseAbs()) / s.peak(p));
  return worst;
}

/// (xi) Returns the largest h |v̇_ip - Ḡ_i| of particles that move with unit velocity along an axis. Ḡ_i is the average
/// gradient over the box of the particle for GIMP weights, and the gradient at the particle otherwise.
template <int D>
double rate_misfit(const MappedBody<D>& body) {
  constexpr double step = 1e-5;
  const bool averaged = std::holds_alternative<solver::Gimp>(body.weighting().particle);
  double worst = 0;
  for (int axis = 0; axis < D; ++axis) {
    const solver::Vec<D> u = step * solver::Vec<D>::Unit(axis);
    const Eigen::MatrixXd rate = (body.moved(body.grid(), body.tiling().translated(u)).v() -
                                  body.moved(body.grid(), body.tiling().translated(-u)).v()) /
                                 (2 * step);
    Eigen::MatrixXd average = body.field().gradients(axis, body.tiling().x);
    if (averaged) {
      average.setZero();
      const DomainQuadrature<D> points(body.tiling(), body.grid());
      const Eigen::MatrixXd gradients = body.field().gradients(axis, points.x);
      const Eigen::VectorXd V = body.tiling().volumes();
      for (std::size_t q = 0; q < points.x.size(); ++q)
        average.col(points.particle[q]) +=
            points.dV[q] / V[points.particle[q]] * gradients.col(static_cast<Eigen::Index>(q));
    }
    keep_larger(worst, body.grid().h[axis] * largest_of((rate - average).cwiseAbs()));
  }
  return worst;
}

}  // namespace mpmvv::checks::mapping
