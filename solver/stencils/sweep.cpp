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

/// Visits the particles of a slab in blocks, one after the other.
template <int D>
class SlabVisit {
 public:
  SlabVisit(int slab, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid)
      : basis_(basis), particles_(particles), grid_(grid), any_(make_block<D>(basis, slab)), block_(common<D>(any_)) {}

  /// Visits the particles from `begin` to before `end`: for each block it evaluates the stencils, and then runs every
  /// kernel in turn. Returns the faults found.
  Fault run(std::size_t begin, std::size_t end, std::span<const AnyKernel<D>> kernels) {
    const bool with_gradients =
        std::any_of(kernels.begin(), kernels.end(), [](const AnyKernel<D>& kernel) { return kernel.uses_gradients(); });
    const auto most = static_cast<std::size_t>(most_particles<D>(any_));
    Fault found = Fault::none;
    for (block_.begin = begin; block_.begin < end; block_.begin += static_cast<std::size_t>(block_.count)) {
      block_.count = static_cast<int>(std::min(most, end - block_.begin));
      const Fault unreached = evaluate(basis_, particles_, grid_, with_gradients, any_);
      found = found | unreached;
      if (unreached != Fault::none) continue;  // the run is over, and these nodes may be those of another slab
      for (const AnyKernel<D>& kernel : kernels) found = found | kernel(any_, grid_);
    }
    return found;
  }

 private:
  const AnyBasis& basis_;
  const Particles<D>& particles_;
  const Grid<D>& grid_;
  AnyBlock<D> any_;
  Block<D>& block_;
};

/// How many particles one of the two sweeps visits before the other has its turn: few enough that a cache near the core
/// still holds them for the second sweep, and enough that the processor does not keep changing between the code of the
/// two.
constexpr std::size_t at_a_time = 512;
template <int... D>
constexpr bool are_whole_blocks = ((at_a_time % block_size<D> == 0 && at_a_time % cpdi_block_size<D> == 0) && ...);
static_assert(are_whole_blocks<1, 2, 3>);

}  // namespace

template <int D>
Fault sweep(Adds adds, const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid, const Slabs<D>& slabs,
            ThreadPool& pool, std::span<const AnyKernel<D>> kernels) {
  std::atomic<unsigned> faults{0};
  for_slabs(adds, slabs, pool, [&](int slab) {
    const auto [begin, end] = slabs.particles(slab);
    faults |= static_cast<unsigned>(SlabVisit<D>(slab, basis, particles, grid).run(begin, end, kernels));
  });
  return static_cast<Fault>(faults.load());
}

template <int D>
std::pair<Fault, Fault> sweep_twice(const AnyBasis& basis, const Particles<D>& particles, const Grid<D>& grid,
                                    const Slabs<D>& slabs, ThreadPool& pool, std::span<const AnyKernel<D>> first,
                                    const std::atomic<bool>& must_sort, std::span<const AnyKernel<D>> second) {
  std::atomic<unsigned> of_first{0}, of_second{0};
  for_slabs(Adds::to_nodes, slabs, pool, [&](int slab) {
    SlabVisit<D> visit(slab, basis, particles, grid);  // with the blocks of a single sweep, so sums keep their order
    const auto [begin, end] = slabs.particles(slab);
    Fault in_first = Fault::none, in_second = Fault::none;
    for (std::size_t p = begin; p < end; p += at_a_time) {
      const std::size_t last = std::min(p + at_a_time, end);
      in_first = in_first | visit.run(p, last, first);
      if (in_first == Fault::none && !must_sort) in_second = in_second | visit.run(p, last, second);
    }
    of_first |= static_cast<unsigned>(in_first);
    of_second |= static_cast<unsigned>(in_second);
  });
  return {static_cast<Fault>(of_first.load()), static_cast<Fault>(of_second.load())};
}

template AnyBlock<1> make_block<1>(const AnyBasis&, int);
template Fault evaluate(const AnyBasis&, const Particles<1>&, const Grid<1>&, bool, AnyBlock<1>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<1>&, const Grid<1>&, const Slabs<1>&, ThreadPool&,
                     std::span<const AnyKernel<1>>);
template std::pair<Fault, Fault> sweep_twice(const AnyBasis&, const Particles<1>&, const Grid<1>&, const Slabs<1>&,
                                             ThreadPool&, std::span<const AnyKernel<1>>, const std::atomic<bool>&,
                                             std::span<const AnyKernel<1>>);
template AnyBlock<2> make_block<2>(const AnyBasis&, int);
template Fault evaluate(const AnyBasis&, const Particles<2>&, const Grid<2>&, bool, AnyBlock<2>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<2>&, const Grid<2>&, const Slabs<2>&, ThreadPool&,
                     std::span<const AnyKernel<2>>);
template std::pair<Fault, Fault> sweep_twice(const AnyBasis&, const Particles<2>&, const Grid<2>&, const Slabs<2>&,
                                             ThreadPool&, std::span<const AnyKernel<2>>, const std::atomic<bool>&,
                                             std::span<const AnyKernel<2>>);
template AnyBlock<3> make_block<3>(const AnyBasis&, int);
template Fault evaluate(const AnyBasis&, const Particles<3>&, const Grid<3>&, bool, AnyBlock<3>&);
template Fault sweep(Adds, const AnyBasis&, const Particles<3>&, const Grid<3>&, const Slabs<3>&, ThreadPool&,
                     std::span<const AnyKernel<3>>);
template std::pair<Fault, Fault> sweep_twice(const AnyBasis&, const Particles<3>&, const Grid<3>&, const Slabs<3>&,
                                             ThreadPool&, std::span<const AnyKernel<3>>, const std::atomic<bool>&,
                                             std::span<const AnyKernel<3>>);

}  // namespace mpmvv::solver
