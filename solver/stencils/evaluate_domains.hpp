#pragma once
#include <Eigen/LU>
#include <algorithm>

#include "solver/basis/basis.hpp"
#include "solver/fault.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/cpdi_block.hpp"
#include "solver/stencils/particle_pack.hpp"

/// Evaluates the stencils of particles that have domains.
namespace mpmvv::solver {

/// The particles of a block in units of cells, by axis: the centres of their domains, from the grid's lower faces, and
/// half of each edge of the domains. The last particle is repeated until the last pack is full.
template <int D>
struct DomainsByAxis {
  alignas(32) double centre[D][cpdi_block_size<D>], half[D][D][cpdi_block_size<D>];
};

/// Finds the domains of a block's particles. Returns a fault if a particle is out of reach of the grid, if a corner
/// lies more than `domain_reach` cells from its particle along an axis, or if a number is NaN.
template <class B, int D>
[[gnu::flatten]] Fault find_domains(const Block<D>& block, const Particles<D>& particles, const Grid<D>& grid,
                                    DomainsByAxis<D>& domains) {
  const double inverse_h = 1 / grid.h(), least = -cells_beyond<B>;
  double most[D];
  for (int d = 0; d < D; ++d) most[d] = next_below(grid.cells()[d] - least);
  Mask4 outside{}, inside{-1, -1, -1, -1};
  for_packs(block, [&](const ParticlePack& pack, int k) {
    const PackVec<D> x = pack.of(particles.x);
    const PackMat<D> half = 0.5 * pack.of(particles.R);
    for (int d = 0; d < D; ++d) {
      store4(confined((x[d] - grid.lower()[d]) * inverse_h, least, most[d], outside).of, &domains.centre[d][k]);
      Double4 extent{};
      for (int e = 0; e < D; ++e) extent += half(d, e).of < 0. ? -half(d, e).of : half(d, e).of;
      const Mask4 fits = extent <= double{domain_reach};
      inside &= fits;
      for (int e = 0; e < D; ++e) store4(fits ? half(d, e).of : Double4{}, &domains.half[d][e][k]);
    }
  });
  return (any(outside) ? Fault::outside : Fault::none) | (all(inside) ? Fault::none : Fault::outgrown);
}

/// Computes 2^(1-D) R^-T of a block's particles, per length.
template <int D>
[[gnu::flatten]] void find_slopes(const Block<D>& block, const Particles<D>& particles, const Grid<D>& grid,
                                  PaddedMat<D>* slope) {
  const double factor = 2 / grid.h() / (1 << D);
  for_packs(block, [&](const ParticlePack& pack, int) {
    Eigen::Matrix<Pack, padded_size<D>, D> four = Eigen::Matrix<Pack, padded_size<D>, D>::Zero();
    four.template topRows<D>() = factor * pack.of(particles.R).inverse().transpose();
    (pack - block.begin).write(four, slope);
  });
}

/// Evaluates the basis at the corners of the domains of a block's particles. If it returns a fault, the stencils of the
/// particles concerned lie somewhere inside storage, and the caller stops the run.
template <int D, class B>
Fault evaluate_stencils(const B& basis, const Particles<D>& particles, const Grid<D>& grid, bool with_gradients,
                        CpdiBlock<D, B::support>& block) {
  using Corners = CpdiStencil<D, B::support>;
  const int padded = block.padded_count();
  DomainsByAxis<D> domains;
  const Fault found = find_domains<B>(block, particles, grid, domains);
  for (auto& first : block.first) std::fill_n(first, padded, grid.node({}));
  for (int d = 0; d < D; ++d) {
    const int cells = grid.cells()[d], stride = grid.stride(d);
    for (int c = 0; c < Corners::corners; ++c)
      for (int k = 0; k < padded; ++k) {
        double xi = domains.centre[d][k];
        for (int e = 0; e < D; ++e) xi += Corners::sign(c, e) * domains.half[d][e][k];
        double N[B::support], dN[B::support];
        block.node[c][d][k] = basis.evaluate({xi, cells, 0}, N, dN);
        block.first[c][k] += stride * block.node[c][d][k];
        for (int i = 0; i < B::support; ++i) block.S[c][d][i][k] = N[i];
      }
  }
  if (with_gradients) find_slopes(block, particles, grid, block.slope);
  return found;
}

}  // namespace mpmvv::solver
