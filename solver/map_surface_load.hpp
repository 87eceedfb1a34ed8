#pragma once
#include <cstdint>
#include <vector>

#include "solver/surface_load.hpp"
#include "solver/sweep.hpp"

namespace mpmvv::solver {

/// f_i += Σ (N_ip + F_p offset · ∇N_ip) force: the weights at the part's middle, continued from its particle's. As
/// those add up to one and are exact on linear fields, force and moment reach the grid whole; and they do on nodes that
/// the particle gives mass, where weights of the middle itself would load nodes beyond the body.
template <int D, class B>
Fault map_surface_load(const B& basis, const SurfaceLoad<D>& load, const Vec<D>* force,
                       const std::vector<std::uint32_t>& place, const Particles<D>& particles, Grid<D>& grid) {
  BlockFor<D, B> block;
  block.count = 1;
  Fault found = Fault::none;
  for (const auto& part : load.parts()) {
    block.begin = place[part.particle];
    found = found | evaluate_stencils(basis, particles, grid, block);
    const Vec<D> reach = particles.F[block.begin] * part.offset;
    ValueAndGradient<D> source{packed<D>(*force), {}};
    for (int d = 0; d < D; ++d) source.gradient.col(d) = reach[d] * source.value;
    block.stencil(0, grid).scatter(source, grid.f);
    ++force;
  }
  return found;
}

}  // namespace mpmvv::solver
