#pragma once
#include <initializer_list>

#include "solver/parallel/slabs.hpp"
#include "solver/stencils/kernel.hpp"
#include "solver/stencils/stencil_bins.hpp"

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
            const StencilBins<D>& bins, ThreadPool& pool, std::initializer_list<AnyKernel<D>> kernels);

}  // namespace mpmvv::solver
