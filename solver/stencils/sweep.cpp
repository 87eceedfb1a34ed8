#include "solver/stencils/sweep.hpp"

#include <algorithm>
#include <atomic>

#include "solver/stencils/evaluate_domains.hpp"
#include "solver/stencils/evaluate_points.hpp"

namespace mpmvv::solver {

template <int D>
AnyBlock<D> make_block(const AnyBasis& basis, int slab) {
  return std::visit([slab]<class B>(const B&) { return AnyBlock<D>(std::in_place_type<BlockOf<D, B>>, slab); }, basis);
}

template <int D>
Fault evaluate(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, bool with_gradients,
               AnyBlock<D>& block) {
  return std::visit(
      [&]<class B>(const B& own) {
        return evaluate_stencils(own, particles, grid, with_gradients, *std::get_if<BlockOf<D, B>>(&block));
      },
      basis);
}

namespace {

template <int D>
int most_places(const AnyBlock<D>& block) {
  return std::visit([](const auto& own) { return own.most; }, block);
}

/// Particles are visited in packs where packs pay and each has nodes of its own. Those with domains go one by one.
template <int D>
void group(AnyBlock<D>& block) {
  std::visit(
      []<class Shape>(Shape& own) {
        if constexpr (has_packs<Shape>)
          own.is_grouped = own.is_grouped && share_their_nodes(own);
        else
          own.is_grouped = false;
      },
      block);
}

/// Has the processor bring what most kernels read of particles near, while others are visited.
template <int D>
void fetch(const PackList<D>& list, const Particles<D>& particles) {
  for (int k = 0; k < list.places(); ++k) {
    const std::uint32_t p = list.particle[k];
    const char* const F = reinterpret_cast<const char*>(particles.F[p].data());
    for (std::size_t byte = 0; byte < sizeof(Mat<D>); byte += 64) __builtin_prefetch(F + byte);
    __builtin_prefetch(particles.x[p].data());
    __builtin_prefetch(particles.v[p].data());
  }
}

template <int D>
Fault sweep_slab(const SlabBins& bins, int slab, const AnyBasis& basis, const Particles<D>& particles,
                 const Grid<D>& grid, std::initializer_list<AnyKernel<D>> kernels) {
  const bool with_gradients =
      std::any_of(kernels.begin(), kernels.end(), [](const AnyKernel<D>& kernel) { return kernel.uses_gradients(); });
  AnyBlock<D> block = make_block<D>(basis, slab);
  const int most = most_places<D>(block);
  Fault found = Fault::none;
  SlabBins::Place at;
  PackList<D> next;
  bins.take(at, most, next);
  while (next.packs > 0) {
    static_cast<PackList<D>&>(common<D>(block)) = next;
    if (bins.take(at, most, next)) fetch(next, particles);
    const Fault unreached = evaluate(basis, particles, grid, with_gradients, block);
    group<D>(block);
    found = found | unreached;
    if (unreached != Fault::none) continue;  // the run is over, and these nodes may be another slab's
    for (const AnyKernel<D>& kernel : kernels) found = found | kernel(block, grid);
  }
  return found;
}

}  // namespace

template <int D>
Fault sweep(Adds adds, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, const Slabs<D>& slabs,
            const StencilBins<D>& bins, ThreadPool& pool, std::initializer_list<AnyKernel<D>> kernels) {
  std::atomic<unsigned> faults{0};
  for_slabs(adds, slabs, pool, [&](int slab) {
    faults |= static_cast<unsigned>(sweep_slab(bins.of(slab), slab, basis, particles, grid, kernels));
  });
  return static_cast<Fault>(faults.load());
}

template AnyBlock<1> make_block<1>(const AnyBasis&, int);
template Fault evaluate(const AnyBasis&, const Particles<1>&, const Grid<1>&, bool, AnyBlock<1>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<1>&, const Grid<1>&, const Slabs<1>&,
                     const StencilBins<1>&, ThreadPool&, std::initializer_list<AnyKernel<1>>);
template AnyBlock<2> make_block<2>(const AnyBasis&, int);
template Fault evaluate(const AnyBasis&, const Particles<2>&, const Grid<2>&, bool, AnyBlock<2>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<2>&, const Grid<2>&, const Slabs<2>&,
                     const StencilBins<2>&, ThreadPool&, std::initializer_list<AnyKernel<2>>);
template AnyBlock<3> make_block<3>(const AnyBasis&, int);
template Fault evaluate(const AnyBasis&, const Particles<3>&, const Grid<3>&, bool, AnyBlock<3>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<3>&, const Grid<3>&, const Slabs<3>&,
                     const StencilBins<3>&, ThreadPool&, std::initializer_list<AnyKernel<3>>);

}  // namespace mpmvv::solver
