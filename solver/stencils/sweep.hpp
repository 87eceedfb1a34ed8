#pragma once
#include <initializer_list>

#include "solver/parallel/slabs.hpp"
#include "solver/stencils/kernel.hpp"

namespace mpmvv::solver {

/// A block of a basis, of this slab.
template <int D>
AnyBlock<D> make_block(const AnyBasis& basis, int slab);

/// The stencil of one particle, with gradients, in a block made by `make_block` of the same basis. A particle out of
/// reach of the grid, one with a width or a domain that the basis cannot take, or a NaN is a fault; its stencil then
/// lies somewhere inside storage.
template <int D>
Fault evaluate_alone(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, std::uint32_t particle,
                     AnyBlock<D>& block);

/// One visit to all particles: block by block the stencils once, then every kernel in turn. No kernel may read on nodes
/// what another one of the sweep changes, nor a later block's particles. Faults as `evaluate_alone` finds them stop the
/// visit to the particle's neighbours: the run is over.
template <int D>
Fault sweep(Adds adds, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, Slabs<D>& slabs,
            ThreadPool& pool, std::initializer_list<AnyKernel<D>> kernels);

}  // namespace mpmvv::solver
