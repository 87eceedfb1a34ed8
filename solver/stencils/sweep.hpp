#pragma once
#include <atomic>
#include <span>
#include <utility>

#include "solver/parallel/slabs.hpp"
#include "solver/stencils/kernel.hpp"

namespace mpmvv::solver {

/// A block of a basis, of this slab.
template <int D>
AnyBlock<D> make_block(const AnyBasis& basis, int slab);

/// Evaluates the basis at the particles of a block, made by `make_block` of the same basis: weights, and gradients if
/// asked for. A particle out of reach of the grid, one with a width or a domain that the basis cannot take, or a NaN is
/// a fault; its stencil then lies somewhere inside storage.
template <int D>
Fault evaluate(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, bool with_gradients,
               AnyBlock<D>& block);

/// One visit to all particles: block by block the stencils once, then every kernel in turn. No kernel may read on nodes
/// what another one of the sweep changes, nor a later block's particles.
template <int D>
Fault sweep(Adds adds, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, const Slabs<D>& slabs,
            ThreadPool& pool, std::span<const AnyKernel<D>> kernels);

/// Two sweeps in one visit, some blocks at a time, so that particles come from memory once: the first moves them, the
/// second takes the stencils that they have then and adds to nodes, none of which the first may read. What follows a
/// fault of the first, or its setting `must_sort`, the second leaves out. Returns the faults of each.
template <int D>
std::pair<Fault, Fault> sweep_twice(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid,
                                    const Slabs<D>& slabs, ThreadPool& pool, std::span<const AnyKernel<D>> first,
                                    const std::atomic<bool>& must_sort, std::span<const AnyKernel<D>> second);

}  // namespace mpmvv::solver
