#pragma once
#include <algorithm>
#include <atomic>
#include <type_traits>

#include "solver/corner_block.hpp"
#include "solver/node_loop.hpp"
#include "solver/particles.hpp"
#include "solver/slabs.hpp"

namespace mpmvv::solver {

/// A stage either returns nothing or the faults that it found.
template <int D, class Stage>
Fault run_stage(Stage& stage, auto& block, const Grid<D>& grid) {
  if constexpr (std::is_same_v<decltype(stage(block, grid)), Fault>) {
    return stage(block, grid);
  } else {
    stage(block, grid);
    return Fault::none;
  }
}

/// The block of a basis.
template <int D, class B, Evaluates evaluates = Evaluates::weights_and_gradients>
using BlockFor = std::conditional_t<B::width == ParticleWidth::domain, CornerBlock<D, B::support, evaluates>,
                                    PointBlock<D, B::support, evaluates>>;

/// Visits the particles of a slab, with stages of its own.
template <int D, class B, class... Stages>
Fault sweep_slab(int slab, const B& basis, const Particles<D>& particles, const Grid<D>& grid, const Slabs<D>& slabs,
                 Stages... stage) {
  constexpr Evaluates evaluates =
      (uses_gradients<Stages> || ...) ? Evaluates::weights_and_gradients : Evaluates::weights;
  BlockFor<D, B, evaluates> block;
  block.slab = slab;
  const auto [begin, end] = slabs.particles(slab);
  Fault found = Fault::none;
  for (block.begin = begin; block.begin < end; block.begin += static_cast<std::size_t>(block.count)) {
    block.count = static_cast<int>(std::min<std::size_t>(block.most, end - block.begin));
    const Fault unreached = set_up(basis, particles, grid, block);
    found = found | unreached;
    if (unreached != Fault::none) continue;  // the run is over, and these nodes may be another slab's
    ((found = found | run_stage(stage, block, grid)), ...);
  }
  return found;
}

/// One visit to all particles: per block the stencils once, then every stage in turn, gradients where one says that it
/// `uses_gradients`.
template <int D, class B, class... Stages>
Fault sweep(Adds adds, const B& basis, const Particles<D>& particles, const Grid<D>& grid, const Slabs<D>& slabs,
            Team& team, const Stages&... stages) {
  std::atomic<unsigned> faults{0};
  for_slabs(adds, slabs, team, [&](int slab) {
    faults |= static_cast<unsigned>(sweep_slab(slab, basis, particles, grid, slabs, stages...));
  });
  return static_cast<Fault>(faults.load());
}

}  // namespace mpmvv::solver
