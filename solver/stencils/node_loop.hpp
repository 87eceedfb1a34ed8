#pragma once
#include <concepts>
#include <cstddef>

#include "solver/stencils/kernel.hpp"
#include "solver/stencils/pack_stencil.hpp"
#include "solver/stencils/particle_pack.hpp"

/// Runs kernels on blocks, and node kernels on the particles of a block.
namespace mpmvv::solver {

/// Calls visit(k) for every k in [0, count), one from each quarter of that range in turn. Neighbouring particles add
/// to the same nodes: visited one right after the other, the second would have to wait for the first.
template <class Visit>
[[gnu::always_inline]] inline void for_interleaved(int count, const Visit& visit) {
  const int stride = (count + 3) / 4;
  for (int start = 0; start < stride; ++start)
    for (int k = start; k < count; k += stride) visit(k);
}

/// Calls a node kernel for a particle, or for four at once, and adds what it returns to its field if it has one.
template <class Kernel>
[[gnu::always_inline]] inline void visit(const Kernel& kernel, const auto& p, const auto& nodes, auto& block) {
  if constexpr (requires { kernel.field(); })
    nodes.scatter(kernel(p, nodes, block), kernel.field());
  else
    kernel(p, nodes, block);
}

/// Visits `count` particles of a block, from the one at place `begin` on, one by one, each with its nodes.
template <int D, class Shape, class... Kernels>
[[gnu::noinline, gnu::flatten]] void visit_each(Shape& block, const Grid<D>& grid, int begin, int count,
                                                const Kernels&... kernels) {
  for_interleaved(count, [&](int k) {
    const auto nodes = block.template stencil<(uses_gradients<Kernels> || ...)>(begin + k, grid);
    (visit(kernels, block.begin + static_cast<std::size_t>(begin + k), nodes, block), ...);
  });
}

/// Visits the particles of a bar in packs of four. The four of a pack are visited at once if they share most of their
/// nodes, else one by one. Returns the number of particles visited: those in whole packs.
template <int K, class... Kernels>
[[gnu::noinline, gnu::flatten]] int visit_packs(PointBlock<1, K>& block, const Grid<1>& grid,
                                                const Kernels&... kernels) {
  const int packs = block.count / 4;
  for_interleaved(packs, [&](int pack) {
    const ParticlePack four{block.begin + static_cast<std::size_t>(4 * pack), 4};
    const auto visit_four = [&](const auto& nodes) __attribute__((always_inline)) {
      (visit(kernels, four, nodes, block), ...);
    };
    if (!visit_together<(uses_gradients<Kernels> || ...)>(block, 4 * pack, visit_four))
      visit_each(block, grid, 4 * pack, 4, kernels...);
  });
  return 4 * packs;
}

/// Visits all particles of a block.
template <int D, class Shape, class... Kernels>
void visit_particles(Shape& block, const Grid<D>& grid, const Kernels&... kernels) {
  int visited = 0;
  if constexpr (is_line<Shape> && (takes_packs<Kernels> && ...)) visited = visit_packs(block, grid, kernels...);
  if (visited < block.count) visit_each(block, grid, visited, block.count - visited, kernels...);
}

template <int D, class Shape, class First, class Second>
void visit_particles(Shape& block, const Grid<D>& grid, const Fused<First, Second>& kernels) {
  visit_particles(block, grid, kernels.first, kernels.second);
}

template <int D, class Kernel>
Fault run_kernel(const Kernel& kernel, AnyBlock<D>& block, const Grid<D>& grid) {
  return std::visit(
      [&]<class Shape>(Shape& own) {
        if constexpr (!std::invocable<const Kernel&, Shape&, const Grid<D>&>)
          visit_particles(own, grid, kernel);
        else if constexpr (std::same_as<std::invoke_result_t<const Kernel&, Shape&, const Grid<D>&>, Fault>)
          return kernel(own, grid);
        else
          kernel(own, grid);
        return Fault::none;
      },
      block);
}

}  // namespace mpmvv::solver
