#pragma once
#include <concepts>
#include <cstddef>

#include "solver/stencils/kernel.hpp"

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

/// Visits the particles of a block one by one, each with its nodes.
template <int D, class Shape, class... Kernels>
[[gnu::noinline, gnu::flatten]] void visit_particles(const Shape& block, const Grid<D>& grid,
                                                     const Kernels&... kernels) {
  for_interleaved(block.count, [&](int k) {
    const auto nodes = block.template stencil<(uses_gradients<Kernels> || ...)>(k, grid);
    const std::size_t p = block.begin + static_cast<std::size_t>(k);
    const auto visit = [&](const auto& kernel) {
      if constexpr (requires { kernel.field(); })
        nodes.scatter(kernel(p, nodes, block), kernel.field());
      else
        kernel(p, nodes, block);
    };
    (visit(kernels), ...);
  });
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
