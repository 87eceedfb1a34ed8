#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "solver/basis/basis.hpp"
#include "solver/fault.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/particle_pack.hpp"
#include "solver/stencils/point_block.hpp"

/// Evaluates the stencils of particles that are points.
namespace mpmvv::solver {

/// The positions of a block's particles, from the grid's lower faces, and their widths, both in cells and by axis.
/// Values that a basis cannot take are moved to the nearest that it can. The last particle is repeated until the last
/// pack is full.
template <int D>
struct PointsByAxis {
  alignas(32) double xi[D][block_size<D>], width[D][block_size<D>];
};

/// Returns the least and the greatest position, in cells, at which a basis may be evaluated along an axis of so many
/// cells.
template <class B>
std::pair<double, double> range_of(int cells) {
  if (B::ghost == 0) return {0, cells};
  return {-cells_beyond<B>, next_below(cells + cells_beyond<B>)};
}

/// Finds the positions and widths of a block's particles. Returns a fault if a particle is out of reach of the grid, if
/// a width that the basis takes lies outside (0, h], or if a number is NaN.
template <class B, int D>
[[gnu::flatten]] Fault find_points(const Block<D>& block, const Particles<D>& particles, const Grid<D>& grid,
                                   PointsByAxis<D>& points) {
  const double inverse_h = 1 / grid.h();
  std::array<std::pair<double, double>, D> range;
  for (int d = 0; d < D; ++d) range[static_cast<std::size_t>(d)] = range_of<B>(grid.cells()[d]);
  Mask4 outside{}, outgrown{};
  for_packs(block, [&](const ParticlePack& pack, int k) {
    const PackVec<D> x = pack.of(particles.x);
    for (int d = 0; d < D; ++d) {
      const auto [least, most] = range[static_cast<std::size_t>(d)];
      const Pack xi = (x[d] - grid.lower()[d]) * inverse_h;
      store4(confined(xi, least, most, outside).of, &points.xi[d][k]);
    }
    if constexpr (B::width != ParticleWidth::none) {
      const PackVec<D> l = pack.of(particles.l);
      for (int d = 0; d < D; ++d)
        store4(confined(l[d], std::numeric_limits<double>::min(), 1, outgrown).of, &points.width[d][k]);
    }
  });
  return (any(outside) ? Fault::outside : Fault::none) | (any(outgrown) ? Fault::outgrown : Fault::none);
}

/// Evaluates the weights of the first `padded` points, and their gradients if asked for.
template <bool with_gradients, int D, class B>
void evaluate_axes(const B& basis, const PointsByAxis<D>& points, const Grid<D>& grid, int padded,
                   PointBlock<D, B::support>& block) {
  const double inverse_h = 1 / grid.h();
  std::fill_n(block.first, padded, grid.node({}));
  for (int d = 0; d < D; ++d) {
    const int cells = grid.cells()[d], stride = grid.stride(d);
    int first[block_size<D>];
    for (int k = 0; k < padded; ++k) {
      double N[B::support], dN[B::support];
      const double width = B::width == ParticleWidth::none ? 0 : points.width[d][k];
      first[k] = basis.evaluate({points.xi[d][k], cells, width}, N, dN);
      for (int i = 0; i < B::support; ++i) {
        block.N[d][i][k] = N[i];
        if constexpr (with_gradients) block.dN[d][i][k] = dN[i] * inverse_h;
      }
    }
    for (int k = 0; k < padded; ++k) block.first[k] += stride * first[k];
  }
}

/// Evaluates the stencils of a block at its particles' positions. If it returns a fault, the stencils of the particles
/// concerned lie somewhere inside storage, and the caller stops the run.
template <int D, class B>
Fault evaluate_stencils(const B& basis, const Particles<D>& particles, const Grid<D>& grid, bool with_gradients,
                        PointBlock<D, B::support>& block) {
  PointsByAxis<D> points;
  const Fault found = find_points<B>(block, particles, grid, points);
  const int padded = block.padded_count();
  if (with_gradients)
    evaluate_axes<true>(basis, points, grid, padded, block);
  else
    evaluate_axes<false>(basis, points, grid, padded, block);
  return found;
}

}  // namespace mpmvv::solver
