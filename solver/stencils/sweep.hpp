#pragma once
#include <atomic>
#include <span>
#include <utility>

#include "solver/parallel/slabs.hpp"
#include "solver/stencils/kernel.hpp"

namespace mpmvv::solver {

/// Makes a block for the particles of a slab, of the type that the basis takes.
template <int D>
AnyBlock<D> make_block(const AnyBasis& basis, int slab);

/// Evaluates the basis at the particles of a block that `make_block` made for the same basis: its weights, and its
/// gradients if asked for. Returns a fault if a particle is out of reach of the grid or has a width or a domain that
/// the basis cannot take, or if a number is NaN. The stencil of such a particle lies somewhere inside storage.
template <int D>
Fault evaluate(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, bool with_gradients,
               AnyBlock<D>& block);

/// Visits all particles once: for each block it evaluates the stencils, and then runs every kernel in turn. Returns the
/// faults found. No kernel may read from nodes what another kernel of the sweep changes, or read the particles of a
/// later block.
template <int D>
Fault sweep(Adds adds, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, const Slabs<D>& slabs,
            ThreadPool& pool, std::span<const AnyKernel<D>> kernels);

/// Makes two sweeps in one visit, some blocks at a time, so that particles come from memory once. The first sweep moves
/// the particles. The second takes the stencils that they have then and adds to fields on nodes, which the first may
/// not read. If the first finds a fault, the second leaves out what follows in that slab; if the first sets
/// `must_sort`, the second leaves out what follows in all slabs. Returns the faults of each sweep.
template <int D>
std::pair<Fault, Fault> sweep_twice(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid,
                                    const Slabs<D>& slabs, ThreadPool& pool, std::span<const AnyKernel<D>> first,
                                    const std::atomic<bool>& must_sort, std::span<const AnyKernel<D>> second);

}  // namespace mpmvv::solver
