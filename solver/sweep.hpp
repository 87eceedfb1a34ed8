#pragma once
#include <algorithm>
#include <atomic>
#include <tuple>
#include <type_traits>

#include "solver/corner_block.hpp"
#include "solver/slabs.hpp"

namespace mpmvv::solver {

/// Visits the particles of a block in four interleaved parts: neighbours add to the same nodes, and one would have to
/// wait for the other.
template <class Visit>
[[gnu::always_inline]] inline void for_interleaved(int count, const Visit& visit) {
  const int stride = (count + 3) / 4;
  for (int start = 0; start < stride; ++start)
    for (int k = start; k < count; k += stride) visit(k);
}

/// Operations on one particle and its nodes, fused into one loop over the block.
template <class... Ops>
struct NodeLoop {
  std::tuple<Ops...> ops;

  template <int D>
  void operator()(const auto& block, const Grid<D>& grid) const {
    for_interleaved(block.count, [&](int k) {
      const auto nodes = block.stencil(k, grid);
      const std::size_t p = block.begin + static_cast<std::size_t>(k);
      std::apply([&](const Ops&... op) { (op(p, nodes, block, k), ...); }, ops);
    });
  }
};

template <>
struct NodeLoop<> {
  template <int D>
  void operator()(const Block<D>&, const Grid<D>&) const {}
};

template <class... Ops>
NodeLoop<Ops...> node_loop(const Ops&... ops) {
  if constexpr (sizeof...(Ops) == 0)
    return {};
  else
    return {std::tuple<Ops...>{ops...}};
}

template <class Op>
inline constexpr bool uses_gradients = false;
template <class Op>
requires Op::uses_gradients inline constexpr bool uses_gradients<Op> = true;
template <class... Ops>
inline constexpr bool uses_gradients<NodeLoop<Ops...>> = (uses_gradients<Ops> || ...);

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

/// One visit to all particles: per block the stencils once, then every stage in turn, gradients where one says that it
/// `uses_gradients`.
template <Adds adds, int D, class B, class... Stages>
Fault sweep(const B& basis, const Particles<D>& particles, const Grid<D>& grid, const Slabs<D>& slabs, Team& team,
            const Stages&... stages) {
  constexpr Evaluates evaluates =
      (uses_gradients<Stages> || ...) ? Evaluates::weights_and_gradients : Evaluates::weights;
  std::atomic<unsigned> faults{0};
  for_slabs<adds>(slabs, team, [&](int slab) {
    std::tuple<Stages...> own{stages...};
    BlockFor<D, B, evaluates> block;
    block.slab = slab;
    const auto [begin, end] = slabs.particles(slab);
    Fault found = Fault::none;
    for (block.begin = begin; block.begin < end; block.begin += block_size<D>) {
      block.count = static_cast<int>(std::min<std::size_t>(block_size<D>, end - block.begin));
      const Fault unreached = evaluate_stencils(basis, particles, grid, block);
      found = found | unreached;
      if (unreached != Fault::none) continue;  // the run is over, and these nodes may be another slab's
      std::apply([&](Stages&... stage) { ((found = found | run_stage(stage, block, grid)), ...); }, own);
    }
    faults |= static_cast<unsigned>(found);
  });
  return static_cast<Fault>(faults.load());
}

}  // namespace mpmvv::solver
