#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/basis/basis.hpp"
#include "solver/fault.hpp"
#include "solver/particles.hpp"
#include "solver/stencils/particle_pack.hpp"
#include "solver/stencils/point_block.hpp"

/// Evaluates the stencils of particles that are points.
namespace mpmvv::solver {

/// The positions of a block's particles from the lower faces, in cells, moved to where a basis may be evaluated, and
/// their widths, by axis.
template <int D>
struct PointsByAxis {
  alignas(64) double xi[D][block_size<D>], width[D][block_size<D>];
};

/// Where a basis may be evaluated along an axis of so many cells, in cells.
template <class B>
std::pair<double, double> range_of(int cells) {
  if (B::ghost == 0) return {0, cells};
  const double least = std::max(1, (B::support - 1) / 2) - B::ghost;
  return {least, std::nextafter(cells - least, 0.0)};
}

/// A particle out of reach of the grid, one whose width is no part of a cell, or a NaN is a fault.
template <class B, int D>
[[gnu::flatten]] Fault find_points(const PackList<D>& block, const Particles<D>& particles, const Grid<D>& grid,
                                   PointsByAxis<D>& points) {
  const double inverse_h = 1 / grid.h();
  std::array<std::pair<double, double>, D> range;
  for (int d = 0; d < D; ++d) range[static_cast<std::size_t>(d)] = range_of<B>(grid.cells()[d]);
  LaneMask outside{}, outgrown{};
  for_packs(block, [&](const ParticlePack<D>& pack, int k) {
    const PackVec<D> x = pack.of(particles.x);
    for (int d = 0; d < D; ++d) {
      const auto [least, most] = range[static_cast<std::size_t>(d)];
      const Pack xi = (x[d] - grid.lower()[d]) * inverse_h;
      store_lanes(confined(xi, least, most, outside).of, &points.xi[d][k]);
    }
    if constexpr (B::width != ParticleWidth::none) {
      const PackVec<D> l = pack.of(particles.l);
      for (int d = 0; d < D; ++d)
        store_lanes(confined(l[d], std::numeric_limits<double>::min(), 1, outgrown).of, &points.width[d][k]);
    }
  });
  return (any(outside) ? Fault::outside : Fault::none) | (any(outgrown) ? Fault::outgrown : Fault::none);
}

/// Calls keep(d, k, N, dN) with the weights of every place k along each axis d and their gradients, per cell, and sets
/// the storage index of its first node.
template <int D, class B, class Keep>
[[gnu::always_inline]] inline void evaluate_axes(const B& basis, const PointsByAxis<D>& points, const Grid<D>& grid,
                                                 int places, int* first, const Keep& keep) {
  std::fill_n(first, places, grid.node({}));
  for (int d = 0; d < D; ++d) {
    const int cells = grid.cells()[d], stride = grid.stride(d);
    int on_axis[block_size<D>];
    for (int k = 0; k < places; ++k) {
      double N[B::support], dN[B::support];
      const double width = B::width == ParticleWidth::none ? 0 : points.width[d][k];
      on_axis[k] = basis.evaluate({points.xi[d][k], cells, width}, N, dN);
      keep(d, k, N, dN);
    }
    for (int k = 0; k < places; ++k) first[k] += stride * on_axis[k];
  }
}

/// Evaluates the stencils of a block at its particles' positions. With a fault the stencils concerned lie somewhere
/// inside storage, and the caller stops the run.
template <int D, class B>
Fault evaluate_stencils(const B& basis, const Particles<D>& particles, const Grid<D>& grid, bool with_gradients,
                        PointBlock<D, B::support>& block) {
  PointsByAxis<D> points;
  const Fault found = find_points<B>(block, particles, grid, points);
  const double inverse_h = 1 / grid.h();
  if (with_gradients)
    evaluate_axes(basis, points, grid, block.places(), block.first, [&](int d, int k, const double* N, const double* dN) {
      for (int i = 0; i < B::support; ++i) block.N[d][i][k] = N[i], block.dN[d][i][k] = dN[i] * inverse_h;
    });
  else
    evaluate_axes(basis, points, grid, block.places(), block.first, [&](int d, int k, const double* N, const double*) {
      for (int i = 0; i < B::support; ++i) block.N[d][i][k] = N[i];
    });
  return found;
}

/// The first nodes of a block's particles alone.
template <int D, class B>
void find_first_nodes(const B& basis, const Particles<D>& particles, const Grid<D>& grid, const PackList<D>& block,
                      int* first) {
  PointsByAxis<D> points;
  find_points<B>(block, particles, grid, points);
  evaluate_axes(basis, points, grid, block.places(), first, [](int, int, const double*, const double*) {});
}

}  // namespace mpmvv::solver
