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

namespace {

/// Calls visit(block) for block after block of a slab's particles, those that reach the same nodes together.
template <int D, class B>
Fault for_blocks(int slab, const B& basis, const Particles<D>& particles, const Grid<D>& grid, bool with_gradients,
                 Slabs<D>& slabs, PointBlock<D, B::support>& block, const auto& visit) {
  Fault found = Fault::none;
  std::int64_t visits = 0;
  const auto [first, last] = slabs.tiles(slab);
  for (std::size_t t = first; t < last; ++t) {
    Tile<D> tile(slabs.order(t));
    const Fault unreached = find_first_nodes(basis, particles, grid, tile);
    found = found | unreached;
    if (unreached != Fault::none) continue;  // these nodes may be another slab's
    visits += slabs.group(t, tile);
    for (int begin = 0, g = 0; begin < tile.count; begin += block.count) {
      evaluate_stencils(basis, tile, begin, g, grid, with_gradients, block);
      visit();
    }
  }
  slabs.add(visits);
  return found;
}

/// Particles that have domains are visited in the order in which they are stored.
template <int D, class B>
Fault for_blocks(int slab, const B& basis, const Particles<D>& particles, const Grid<D>& grid, bool with_gradients,
                 Slabs<D>& slabs, CpdiBlock<D, B::support>& block, const auto& visit) {
  Fault found = Fault::none;
  const auto [begin, end] = slabs.particles(slab);
  for (std::size_t p = begin; p < end; p += block.most) {
    block.particle = slabs.stored(p, end).data(), block.count = static_cast<int>(std::min<std::size_t>(block.most, end - p));
    const Fault unreached = evaluate_stencils(basis, particles, grid, with_gradients, block);
    found = found | unreached;
    if (unreached == Fault::none) visit();
  }
  return found;
}

template <int D>
Fault sweep_slab(int slab, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, Slabs<D>& slabs,
                 std::initializer_list<AnyKernel<D>> kernels) {
  const bool with_gradients =
      std::any_of(kernels.begin(), kernels.end(), [](const AnyKernel<D>& kernel) { return kernel.uses_gradients(); });
  AnyBlock<D> block = make_block<D>(basis, slab);
  Fault found = Fault::none;
  const auto visit = [&] {
    for (const AnyKernel<D>& kernel : kernels) found = found | kernel(block, grid);
  };
  const Fault unreached = std::visit(
      [&]<class B>(const B& own) {
        return for_blocks(slab, own, particles, grid, with_gradients, slabs, *std::get_if<BlockOf<D, B>>(&block),
                          visit);
      },
      basis);
  return found | unreached;
}

}  // namespace

template <int D>
Fault evaluate_alone(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, std::uint32_t particle,
                     AnyBlock<D>& block) {
  return std::visit(
      [&]<class B>(const B& own) {
        return evaluate_alone(own, particles, grid, particle, *std::get_if<BlockOf<D, B>>(&block));
      },
      basis);
}

template <int D>
Fault sweep(Adds adds, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, Slabs<D>& slabs,
            ThreadPool& pool, std::initializer_list<AnyKernel<D>> kernels) {
  std::atomic<unsigned> faults{0};
  for_slabs(adds, slabs, pool, [&](int slab) {
    faults |= static_cast<unsigned>(sweep_slab(slab, basis, particles, grid, slabs, kernels));
  });
  slabs.end_sweep();
  return static_cast<Fault>(faults.load());
}

template AnyBlock<1> make_block<1>(const AnyBasis&, int);
template Fault evaluate_alone(const AnyBasis&, const Particles<1>&, const Grid<1>&, std::uint32_t, AnyBlock<1>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<1>&, const Grid<1>&, Slabs<1>&, ThreadPool&,
                     std::initializer_list<AnyKernel<1>>);
template AnyBlock<2> make_block<2>(const AnyBasis&, int);
template Fault evaluate_alone(const AnyBasis&, const Particles<2>&, const Grid<2>&, std::uint32_t, AnyBlock<2>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<2>&, const Grid<2>&, Slabs<2>&, ThreadPool&,
                     std::initializer_list<AnyKernel<2>>);
template AnyBlock<3> make_block<3>(const AnyBasis&, int);
template Fault evaluate_alone(const AnyBasis&, const Particles<3>&, const Grid<3>&, std::uint32_t, AnyBlock<3>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<3>&, const Grid<3>&, Slabs<3>&, ThreadPool&,
                     std::initializer_list<AnyKernel<3>>);

}  // namespace mpmvv::solver
