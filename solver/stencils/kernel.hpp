#pragma once
#include "solver/fault.hpp"
#include "solver/grid.hpp"
#include "solver/stencils/any_block.hpp"

/// Kernels: what a sweep does to a block of particles. There are two kinds.
///
/// A *block kernel* is called once for each block, kernel(block, grid), and returns nothing or the faults that it
/// found.
///
/// A *node kernel* is called for each particle with the nodes that it reaches, kernel(p, nodes, block). It may store in
/// the block what later block kernels use (L). It declares `uses_gradients` if it uses the gradients of the weights,
/// and `takes_packs` if `p` may stand for four particles of a bar at once (stencils/particle_pack.hpp). A node kernel
/// that maps to nodes offers the `field()` that it adds to, and returns what the particle adds to it: a value, which is
/// multiplied by the weights of the nodes, or a `ValueAndGradient` (stencils/stencil.hpp) if gradients take part.
namespace mpmvv::solver {

template <class Kernel>
inline constexpr bool uses_gradients = false;
template <class Kernel>
requires Kernel::uses_gradients inline constexpr bool uses_gradients<Kernel> = true;

template <class Kernel>
inline constexpr bool takes_packs = false;
template <class Kernel>
requires(Kernel::takes_packs) inline constexpr bool takes_packs<Kernel> = true;

/// Two node kernels that run in one loop over the particles. Neither may read from nodes what the other changes. A step
/// that maps momentum and forces in this way takes 1 to 3 % fewer instructions.
template <class First, class Second>
struct Fused {
  static constexpr bool uses_gradients = solver::uses_gradients<First> || solver::uses_gradients<Second>;
  First first;
  Second second;
};
template <class First, class Second>
Fused(const First&, const Second&) -> Fused<First, Second>;

/// Runs a kernel on a block. It is defined in stencils/node_loop.hpp. Kernels that several files run are listed in
/// solver/kernels/compiled.hpp; a file with a kernel of its own includes the definition.
template <int D, class Kernel>
Fault run_kernel(const Kernel& kernel, AnyBlock<D>& block, const Grid<D>& grid);

/// Refers to a kernel of any type, to be called once for each block of particles. Valid as long as that kernel exists.
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
