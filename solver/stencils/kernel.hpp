#pragma once
#include "solver/fault.hpp"
#include "solver/grid.hpp"
#include "solver/stencils/any_block.hpp"

/// Kernels: what a sweep does to a block of particles. There are two kinds.
///
/// A *block kernel* is called once a block, kernel(block, grid), and returns nothing or the faults that it found.
///
/// A *node kernel* is called for each particle with its nodes: kernel(p, nodes, block), and may leave in its block what
/// block kernels after it take up (L). It may say `uses_gradients`, and `takes_packs` where `p` may be four particles
/// of a bar at once (stencils/particle_pack.hpp). One that maps to nodes returns what the particle adds to those of its
/// `field()`.
namespace mpmvv::solver {

template <class Kernel>
inline constexpr bool uses_gradients = false;
template <class Kernel>
requires Kernel::uses_gradients inline constexpr bool uses_gradients<Kernel> = true;

template <class Kernel>
inline constexpr bool takes_packs = false;
template <class Kernel>
requires(Kernel::takes_packs) inline constexpr bool takes_packs<Kernel> = true;

/// Two node kernels in one loop over the particles, where neither reads on nodes what the other changes: a step that
/// maps momentum and forces so takes 1 to 3 % fewer instructions.
template <class First, class Second>
struct Fused {
  static constexpr bool uses_gradients = solver::uses_gradients<First> || solver::uses_gradients<Second>;
  First first;
  Second second;
};
template <class First, class Second>
Fused(const First&, const Second&) -> Fused<First, Second>;

/// Runs a kernel on a block: defined in stencils/node_loop.hpp. Kernels that several files run are listed
/// in solver/kernels/compiled.hpp; a file with a kernel of its own includes the definition.
template <int D, class Kernel>
Fault run_kernel(const Kernel& kernel, AnyBlock<D>& block, const Grid<D>& grid);

/// A kernel of any type, called once per block of particles. Valid as long as the kernel.
template <int D>
class AnyKernel {
 public:
  template <class Kernel>
  AnyKernel(const Kernel& kernel)
      : kernel_(&kernel),
        run_([](const void* own, AnyBlock<D>& block, const Grid<D>& grid) {
          return run_kernel<D>(*static_cast<const Kernel*>(own), block, grid);
        }),
        uses_gradients_(solver::uses_gradients<Kernel>) {}

  Fault operator()(AnyBlock<D>& block, const Grid<D>& grid) const { return run_(kernel_, block, grid); }
  bool uses_gradients() const { return uses_gradients_; }

 private:
  const void* kernel_;
  Fault (*run_)(const void* kernel, AnyBlock<D>& block, const Grid<D>& grid);
  bool uses_gradients_;
};

}  // namespace mpmvv::solver
