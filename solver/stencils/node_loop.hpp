#pragma once
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>

#include "solver/stencils/kernel.hpp"
#include "solver/stencils/pack_stencil.hpp"
#include "solver/stencils/particle_pack.hpp"

/// Runs kernels on blocks, and node kernels on the particles of a block.
namespace mpmvv::solver {

/// Visits the particles of a block in four interleaved parts: neighbours add to the same nodes, and one would have to
/// wait for the other.
template <class Visit>
[[gnu::always_inline]] inline void for_interleaved(int count, const Visit& visit) {
  const int stride = (count + 3) / 4;
  for (int start = 0; start < stride; ++start)
    for (int k = start; k < count; k += stride) visit(k);
}

template <class Kernel>
inline constexpr bool maps_to_nodes = requires(const Kernel& kernel) {
  kernel.field();
};

/// Visits each particle by itself.
template <int D, class Shape, class Kernel>
void visit_each(const Kernel& kernel, const Shape& block, const Grid<D>& grid) {
  for_interleaved(block.count, [&](int k) {
    const auto nodes = block.template stencil<uses_gradients<Kernel>>(k, grid);
    const ParticleRef<D> particle{block.begin, k};
    if constexpr (maps_to_nodes<Kernel>)
      nodes.scatter(kernel(particle, nodes, block), kernel.field());
    else
      kernel(particle, nodes, block);
  });
}

/// What the packs of a group add to its nodes; nothing for a kernel that does not map.
template <class Source, int packs>
struct Sources {
  Sources() {}  // leaves them unset: each is written before it is read
  Source of[packs];
};
struct None {};

/// Visits four particles at a time, group by group, whose sums are brought to the nodes at its end.
template <int D, int K, class Kernel>
[[gnu::noinline, gnu::flatten]] void visit_packs(const Kernel& kernel, const PointBlock<D, K>& block,
                                                 const Grid<D>& grid) {
  using Nodes = PackStencil<D, K>;
  using Result = std::invoke_result_t<const Kernel&, const ParticlePack<D>&, const Nodes&, const PointBlock<D, K>&>;
  [[maybe_unused]] std::conditional_t<maps_to_nodes<Kernel>, Sources<Result, block_size<D> / 4>, None> sources;
  for (int g = 0; g < block.groups; ++g) {
    const int begin = block.group[g], end = block.group[g + 1];
    for (int k = begin; k < end; k += 4) {
      const ParticlePack<D> pack(block.begin, k, std::min(end - k, 4));
      const Nodes nodes(block, grid, k);
      if constexpr (maps_to_nodes<Kernel>)
        sources.of[(k - begin) / 4] = first_of(kernel(pack, nodes, block), pack.count());
      else
        kernel(pack, nodes, block);
    }
    if constexpr (maps_to_nodes<Kernel>)
      Nodes(block, grid, begin).scatter(sources.of, (end - begin + 3) / 4, kernel.field());
  }
}

template <int D, class Shape, class Kernel>
void visit_nodes(const Kernel& kernel, const Shape& block, const Grid<D>& grid) {
  if constexpr (requires { kernel.prepare(block, grid); }) kernel.prepare(block, grid);
  if constexpr (requires { block.groups; })
    if (block.is_grouped) return visit_packs(kernel, block, grid);
  visit_each(kernel, block, grid);
}

template <int D, class Kernel>
Fault run_kernel(const Kernel& kernel, AnyBlock<D>& block, const Grid<D>& grid) {
  return std::visit(
      [&]<class Shape>(Shape& own) {
        if constexpr (!std::invocable<const Kernel&, Shape&, const Grid<D>&>)
          visit_nodes(kernel, own, grid);
        else if constexpr (std::same_as<std::invoke_result_t<const Kernel&, Shape&, const Grid<D>&>, Fault>)
          return kernel(own, grid);
        else
          kernel(own, grid);
        return Fault::none;
      },
      block);
}

}  // namespace mpmvv::solver
