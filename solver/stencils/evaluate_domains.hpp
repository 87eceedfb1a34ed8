#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "solver/basis/basis.hpp"
#include "solver/fault.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/cpdi_block.hpp"

/// Evaluates the stencils of particles that have domains.
namespace mpmvv::solver {

/// `value` moved into [least, most], a NaN to `least`; counts in `strays` those that had to be moved.
inline double confined(double value, double least, double most, int& strays) {
  const double inside = std::min(std::max(least, value), most);
  strays += inside == value ? 0 : 1;
  return inside;
}

/// A block's particles along one axis, in cells: where they are, and half of each edge of their domains.
template <int D>
struct DomainsOnAxis {
  double centre[cpdi_block_size<D>], half[D][cpdi_block_size<D>];
};

/// A particle out of reach of the grid, a corner more than `domain_reach` cells from its particle, or a NaN is a fault.
template <class B, int D>
Fault find_domains(const PackList<D>& block, const Particles<D>& particles, const Grid<D>& grid, int axis,
                   DomainsOnAxis<D>& domains) {
  const double inverse_h = 1 / grid.h(), lower = grid.lower()[axis];
  const double least = 1 + domain_reach - B::ghost, most = std::nextafter(grid.cells()[axis] - least, 0.0);
  int outside = 0, outgrown = 0;
  for (int k = 0; k < block.places(); ++k) {
    const std::size_t p = block.particle[k];
    const Mat<D>& R = particles.R[p];
    domains.centre[k] = confined((particles.x[p][axis] - lower) * inverse_h, least, most, outside);
    double extent = 0;
    for (int e = 0; e < D; ++e) extent += std::abs(R(axis, e)) / 2;
    const bool fits = extent <= domain_reach;
    outgrown += fits ? 0 : 1;
    for (int e = 0; e < D; ++e) domains.half[e][k] = fits ? R(axis, e) / 2 : 0;
  }
  return (outside > 0 ? Fault::outside : Fault::none) | (outgrown > 0 ? Fault::outgrown : Fault::none);
}

/// Evaluates the basis at the corners of the domains of a block's particles. With a fault the stencils concerned lie
/// somewhere inside storage, and the caller stops the run.
template <int D, class B>
Fault evaluate_stencils(const B& basis, const Particles<D>& particles, const Grid<D>& grid, bool with_gradients,
                        CpdiBlock<D, B::support>& block) {
  using Corners = CpdiStencil<D, B::support>;
  const int count = block.places();
  Fault found = Fault::none;
  for (auto& first : block.first) std::fill_n(first, count, grid.node({}));
  for (int d = 0; d < D; ++d) {
    const int cells = grid.cells()[d], stride = grid.stride(d);
    DomainsOnAxis<D> domains;
    found = found | find_domains<B>(block, particles, grid, d, domains);
    for (int c = 0; c < Corners::corners; ++c)
      for (int k = 0; k < count; ++k) {
        double xi = domains.centre[k];
        for (int e = 0; e < D; ++e) xi += Corners::sign(c, e) * domains.half[e][k];
        double N[B::support], dN[B::support];
        block.node[c][d][k] = basis.evaluate({xi, cells, 0}, N, dN);
        block.first[c][k] += stride * block.node[c][d][k];
        for (int i = 0; i < B::support; ++i) block.S[c][d][i][k] = N[i];
      }
  }
  if (with_gradients) {
    const double factor = 2 / grid.h() / Corners::corners;
    for (int k = 0; k < count; ++k)
      block.slope[k] = factor * particles.R[block.particle[k]].inverse().transpose();
  }
  return found;
}

}  // namespace mpmvv::solver
