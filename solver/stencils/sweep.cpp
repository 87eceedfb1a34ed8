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
int most_particles(const AnyBlock<D>& block) {
  return std::visit([](const auto& own) { return own.most; }, block);
}

template <int D>
Fault sweep_slab(int slab, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid,
                 const Slabs<D>& slabs, std::initializer_list<AnyKernel<D>> kernels) {
  const bool with_gradients =
      std::any_of(kernels.begin(), kernels.end(), [](const AnyKernel<D>& kernel) { return kernel.uses_gradients(); });
  AnyBlock<D> any = make_block<D>(basis, slab);
  Block<D>& block = common<D>(any);
  const auto most = static_cast<std::size_t>(most_particles<D>(any));
  const auto [begin, end] = slabs.particles(slab);
  Fault found = Fault::none;
  for (block.begin = begin; block.begin < end; block.begin += static_cast<std::size_t>(block.count)) {
    block.count = static_cast<int>(std::min(most, end - block.begin));
    const Fault unreached = evaluate(basis, particles, grid, with_gradients, any);
    found = found | unreached;
    if (unreached != Fault::none) continue;  // the run is over, and these nodes may be another slab's
    for (const AnyKernel<D>& kernel : kernels) found = found | kernel(any, grid);
  }
  return found;
}

}  // namespace

template <int D>
Fault sweep(Adds adds, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, const Slabs<D>& slabs,
            ThreadPool& pool, std::initializer_list<AnyKernel<D>> kernels) {
  std::atomic<unsigned> faults{0};
  for_slabs(adds, slabs, pool, [&](int slab) {
    faults |= static_cast<unsigned>(sweep_slab(slab, basis, particles, grid, slabs, kernels));
  });
  return static_cast<Fault>(faults.load());
}

template AnyBlock<1> make_block<1>(const AnyBasis&, int);
template Fault evaluate(const AnyBasis&, const Particles<1>&, const Grid<1>&, bool, AnyBlock<1>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<1>&, const Grid<1>&, const Slabs<1>&, ThreadPool&,
                     std::initializer_list<AnyKernel<1>>);
template AnyBlock<2> make_block<2>(const AnyBasis&, int);
template Fault evaluate(const AnyBasis&, const Particles<2>&, const Grid<2>&, bool, AnyBlock<2>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<2>&, const Grid<2>&, const Slabs<2>&, ThreadPool&,
                     std::initializer_list<AnyKernel<2>>);
template AnyBlock<3> make_block<3>(const AnyBasis&, int);
template Fault evaluate(const AnyBasis&, const Particles<3>&, const Grid<3>&, bool, AnyBlock<3>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<3>&, const Grid<3>&, const Slabs<3>&, ThreadPool&,
                     std::initializer_list<AnyKernel<3>>);

}  // namespace mpmvv::solver
