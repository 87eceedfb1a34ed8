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

/// Visits places in four interleaved parts: neighbours add to the same nodes, and one would have to wait for the other.
template <class Visit>
[[gnu::always_inline]] inline void for_interleaved(int places, const Visit& visit) {
  const int stride = (places + 3) / 4;
  for (int start = 0; start < stride; ++start)
    for (int k = start; k < places; k += stride) visit(k);
}

template <class Kernel>
inline constexpr bool maps_to_nodes = requires(const Kernel& kernel) {
  kernel.field();
};

/// Visits each particle by itself.
template <int D, class Shape, class... Kernels>
[[gnu::noinline, gnu::flatten]] void visit_each(const Shape& block, const Grid<D>& grid, const Kernels&... kernels) {
  for_interleaved(block.places(), [&](int k) {
    if (!block.is_filled(k)) return;
    const auto nodes = block.template stencil<(uses_gradients<Kernels> || ...)>(k, grid);
    const ParticleRef<D> particle{block.particle[k], k};
    const auto visit = [&]<class Kernel>(const Kernel& kernel) {
      if constexpr (maps_to_nodes<Kernel>)
        nodes.scatter(kernel(particle, nodes, block), kernel.field());
      else
        kernel(particle, nodes, block);
    };
    (visit(kernels), ...);
  });
}

/// A kernel on the packs of a group, and what these add to its nodes.
template <int D, class Kernel, class Nodes, class Block>
class OnGroup {
 public:
  explicit OnGroup(const Kernel& kernel) : kernel_(kernel) {}  // leaves the sources unset: each is written before read

  void visit(const ParticlePack<D>& pack, const Nodes& nodes, const Block& block, int place) {
    if constexpr (maps_to_nodes<Kernel>)
      set_first(kernel_(pack, nodes, block), first_lanes(pack.count()), sources_[static_cast<std::size_t>(place)]);
    else
      kernel_(pack, nodes, block);
  }
  void scatter(const Nodes& nodes, int packs) const {
    if constexpr (maps_to_nodes<Kernel>) nodes.scatter(sources_.data(), packs, kernel_.field());
  }

 private:
  struct None {};
  using Source = std::invoke_result_t<const Kernel&, const ParticlePack<D>&, const Nodes&, const Block&>;
  const Kernel& kernel_;
  std::conditional_t<maps_to_nodes<Kernel>, std::array<Source, Block::most_packs>, None> sources_;
};

template <class Nodes, int D, class Block, class... Kernels>
void visit_groups(const Block& block, const Grid<D>& grid, OnGroup<D, Kernels, Nodes, Block>&&... on_group) {
  for (int g = 0; g < block.groups; ++g) {
    const int begin = block.group[g], end = block.group[g + 1];
    for (int k = begin; k < end; ++k) {
      const Nodes nodes(block, grid, k * lanes);
      (on_group.visit(ParticlePack<D>(block, k), nodes, block, k - begin), ...);
    }
    const Nodes nodes(block, grid, begin * lanes);
    (on_group.scatter(nodes, end - begin), ...);
  }
}

/// Visits a pack at a time, group by group, whose sums are brought to the nodes at its end.
template <int D, int K, class... Kernels>
[[gnu::noinline, gnu::flatten]] void visit_packs(const PointBlock<D, K>& block, const Grid<D>& grid,
                                                 const Kernels&... kernels) {
  using Nodes = PackStencil<D, K>;
  visit_groups<Nodes>(block, grid, OnGroup<D, Kernels, Nodes, PointBlock<D, K>>(kernels)...);
}

template <int D, class Shape, class... Kernels>
void visit_nodes(const Shape& block, const Grid<D>& grid, const Kernels&... kernels) {
  const auto prepare = [&](const auto& kernel) {
    if constexpr (requires { kernel.prepare(block, grid); }) kernel.prepare(block, grid);
  };
  (prepare(kernels), ...);
  if constexpr (has_packs<Shape>)
    if (block.is_grouped) return visit_packs(block, grid, kernels...);
  visit_each(block, grid, kernels...);
}
template <int D, class Shape, class First, class Second>
void visit_nodes(const Shape& block, const Grid<D>& grid, const Fused<First, Second>& kernels) {
  visit_nodes(block, grid, kernels.first, kernels.second);
}

template <int D, class Kernel>
Fault run_kernel(const Kernel& kernel, AnyBlock<D>& block, const Grid<D>& grid) {
  return std::visit(
      [&]<class Shape>(Shape& own) {
        if constexpr (!std::invocable<const Kernel&, Shape&, const Grid<D>&>)
          visit_nodes(own, grid, kernel);
        else if constexpr (std::same_as<std::invoke_result_t<const Kernel&, Shape&, const Grid<D>&>, Fault>)
          return kernel(own, grid);
        else
          kernel(own, grid);
        return Fault::none;
      },
      block);
}

}  // namespace mpmvv::solver
