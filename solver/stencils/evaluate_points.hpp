#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/basis/basis.hpp"
#include "solver/fault.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/particle_pack.hpp"
#include "solver/stencils/point_block.hpp"
#include "solver/stencils/stencil_groups.hpp"
#include "solver/stencils/tile.hpp"

/// Evaluates the stencils of particles that are points.
namespace mpmvv::solver {

/// Where a basis may be evaluated along an axis of so many cells, in cells.
template <class B>
std::pair<double, double> range_of(int cells) {
  if (B::ghost == 0) return {0, cells};
  const double least = std::max(1, (B::support - 1) / 2) - B::ghost;
  return {least, std::nextafter(cells - least, 0.0)};
}

/// Fills up what may be read beyond the last particle of a tile.
template <class B, int D>
void repeat_last(Tile<D>& tile) {
  const auto repeat = [&tile](auto* values) { std::fill_n(values + tile.count, 8, values[tile.count - 1]); };
  repeat(tile.particle);
  repeat(tile.first);
  for (int d = 0; d < D; ++d) {
    repeat(tile.xi[d]);
    if constexpr (B::width != ParticleWidth::none) repeat(tile.width[d]);
  }
}

/// Where the particles of a tile are, and the first node that each reaches. A particle out of reach of the grid, one
/// whose width is no part of a cell, or a NaN is a fault; it is then moved to where the basis may be evaluated.
template <class B, int D>
[[gnu::flatten]] Fault find_first_nodes(const B& basis, const Particles<D>& particles, const Grid<D>& grid,
                                        Tile<D>& tile) {
  const double inverse_h = 1 / grid.h();
  Mask4 outside{}, outgrown{};
  for_packs<D>(tile, [&](const ParticlePack<D>& pack, int k) {
    const PackVec<D> x = pack.of(particles.x);
    for (int d = 0; d < D; ++d) {
      const auto [least, most] = range_of<B>(grid.cells()[d]);
      const Pack xi = (x[d] - grid.lower()[d]) * inverse_h;
      store4(confined(xi, least, most, outside).of, &tile.xi[d][k]);
    }
    if constexpr (B::width != ParticleWidth::none) {
      const PackVec<D> l = pack.of(particles.l);
      for (int d = 0; d < D; ++d)
        store4(confined(l[d], std::numeric_limits<double>::min(), 1, outgrown).of, &tile.width[d][k]);
    }
  });
  std::fill_n(tile.first, tile.count, grid.node({}));
  for (int d = 0; d < D; ++d) {
    const int cells = grid.cells()[d], stride = grid.stride(d);
    for (int k = 0; k < tile.count; ++k) {
      double N[B::support], dN[B::support];
      const double width = B::width == ParticleWidth::none ? 0 : tile.width[d][k];
      tile.first[k] += stride * basis.evaluate({tile.xi[d][k], cells, width}, N, dN);
    }
  }
  repeat_last<B>(tile);
  find_groups(tile);
  return (any(outside) ? Fault::outside : Fault::none) | (any(outgrown) ? Fault::outgrown : Fault::none);
}

/// The next particles of a tile, from a place in its group g on: as many groups as fit, or as much of that one.
template <int D, int K>
void take_groups(const Tile<D>& tile, int begin, int& g, PointBlock<D, K>& block) {
  const int most = begin + block.most;
  int end = std::min(tile.group[g + 1], most);
  block.groups = 1;
  block.group[0] = 0;
  if (end == tile.group[g + 1])
    for (++g; g < tile.groups && tile.group[g + 1] <= most; ++g) {
      block.group[block.groups++] = end - begin;
      end = tile.group[g + 1];
    }
  block.group[block.groups] = end - begin;
  block.count = end - begin;
  block.particle = tile.particle + begin;
  block.first = tile.first + begin;
}

/// Weights of a block's particles, whose places in the tile begin at `begin`, and of a pack more; their gradients if
/// these are asked for.
template <bool with_gradients, int D, class B>
void evaluate_axes(const B& basis, const Tile<D>& tile, int begin, const Grid<D>& grid,
                   PointBlock<D, B::support>& block) {
  const double inverse_h = 1 / grid.h();
  const int padded = (block.count + 6) / 4 * 4;
  for (int d = 0; d < D; ++d) {
    const int cells = grid.cells()[d];
    for (int k = 0; k < padded; ++k) {
      double N[B::support], dN[B::support];
      const double width = B::width == ParticleWidth::none ? 0 : tile.width[d][begin + k];
      basis.evaluate({tile.xi[d][begin + k], cells, width}, N, dN);
      for (int i = 0; i < B::support; ++i) {
        block.N[d][i][k] = N[i];
        if constexpr (with_gradients) block.dN[d][i][k] = dN[i] * inverse_h;
      }
    }
  }
}

/// The stencils of the tile's particles from a place in its group g on; g is then that of the next.
template <int D, class B>
void evaluate_stencils(const B& basis, const Tile<D>& tile, int begin, int& g, const Grid<D>& grid,
                       bool with_gradients, PointBlock<D, B::support>& block) {
  take_groups(tile, begin, g, block);
  if (with_gradients)
    evaluate_axes<true>(basis, tile, begin, grid, block);
  else
    evaluate_axes<false>(basis, tile, begin, grid, block);
}

/// The stencil of one particle.
template <int D, class B>
Fault evaluate_alone(const B& basis, const Particles<D>& particles, const Grid<D>& grid, std::uint32_t particle,
                     PointBlock<D, B::support>& block) {
  Tile<D> tile({&particle, 1});
  const Fault found = find_first_nodes(basis, particles, grid, tile);
  int g = 0;
  evaluate_stencils(basis, tile, 0, g, grid, true, block);
  return found;
}

}  // namespace mpmvv::solver
