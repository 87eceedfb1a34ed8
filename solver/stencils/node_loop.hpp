#pragma once
#include <concepts>
#include <cstddef>

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

/// Calls a node kernel for a particle, or for four at once.
template <class Kernel>
[[gnu::always_inline]] inline void visit(const Kernel& kernel, const auto& p, const auto& nodes, const auto& block) {
  if constexpr (requires { kernel.field(); })
    nodes.scatter(kernel(p, nodes, block), kernel.field());
  else
    kernel(p, nodes, block);
}

/// Visits the particles of a block with their nodes: one by one, or those of a bar by four, where the kernels take
/// packs and the four share most of their nodes.
template <int D, class Shape, class... Kernels>
[[gnu::noinline, gnu::flatten]] void visit_particles(const Shape& block, const Grid<D>& grid,
                                                     const Kernels&... kernels) {
  const auto visit_all = [&](const auto& p, const auto& nodes) __attribute__((always_inline)) {
    (visit(kernels, p, nodes, block), ...);
  };
  const auto visit_one = [&](int k) __attribute__((always_inline)) {
    visit_all(block.begin + static_cast<std::size_t>(k),
              block.template stencil<(uses_gradients<Kernels> || ...)>(k, grid));
  };
  if constexpr (is_line<Shape> && (takes_packs<Kernels> && ...)) {
    const int packs = block.count / 4;
    for_interleaved(packs, [&](int pack) {
      const int k = 4 * pack;
      const ParticlePack four{block.begin + static_cast<std::size_t>(k), 4};
      const bool visited = visit_together(
          block, k, [&](const auto& nodes) __attribute__((always_inline)) { visit_all(four, nodes); });
      if (!visited)
        for (int one = k; one < k + 4; ++one) visit_one(one);
    });
    for (int k = 4 * packs; k < block.count; ++k) visit_one(k);
  } else {
    for_interleaved(block.count, visit_one);
  }
}

template <int D, class Shape, class First, class Second>
void visit_particles(const Shape& block, const Grid<D>& grid, const Fused<First, Second>& kernels) {
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
