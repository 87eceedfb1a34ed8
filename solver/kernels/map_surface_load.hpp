#pragma once
#include <cstdint>

#include "solver/stencils/sweep.hpp"
#include "solver/surface_load.hpp"

namespace mpmvv::solver {

/// Maps the forces on parts of the surface, f_i += Σ (N_ip + F_p offset · ∇N_ip) force. The weights are those at the
/// particle of each part, extrapolated to the middle of the part. They add up to one and are exact on linear fields, so
/// force and moment reach the grid whole. They load only nodes that the particle gives mass; the weights at the middle
/// itself would also load nodes beyond the body. `force` has one entry per part, and `place` the index of the particle
/// with each id. Returns the faults found at the particles.
template <int D>
Fault map_surface_load(const AnyBasis& basis, const SurfaceLoad<D>& load, const Vec<D>* force,
                       const Array<std::uint32_t>& place, const Particles<D>& particles, Grid<D>& grid) {
  AnyBlock<D> block = make_block<D>(basis, 0);
  common<D>(block).count = 1;
  Fault found = Fault::none;
  for (const auto& part : load.parts()) {
    const std::size_t p = common<D>(block).begin = place[part.particle];
    found = found | evaluate<D>(basis, particles, grid, true, block);
    const Vec<D> reach = particles.F[p] * part.offset;
    ValueAndGradient<D> source{padded<D>(*force), {}};
    for (int d = 0; d < D; ++d) source.gradient.col(d) = reach[d] * source.value;
    std::visit([&](const auto& own) { own.stencil(0, grid).scatter(source, grid.f); }, block);
    ++force;
  }
  return found;
}

}  // namespace mpmvv::solver
