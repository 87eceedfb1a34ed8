#include "solver/kernels/block_kernels.hpp"

#include <tuple>

#include "solver/stencils/node_loop.hpp"

namespace mpmvv::solver {

/// Compiled once for all pages.
template <int D>
struct BlockKernels {
  static constexpr std::tuple all{&run_kernel<D, EvaluateStress<D>>,    &run_kernel<D, EvaluateBodyForce<D>>,
                                  &run_kernel<D, UpdateDeformation<D>>, &run_kernel<D, CheckDeformation<D>>,
                                  &run_kernel<D, UpdateWidth<D>>,       &run_kernel<D, MoveByRate<D>>,
                                  &run_kernel<D, SettlePosition<D>>};
};

template struct BlockKernels<1>;
template struct BlockKernels<2>;
template struct BlockKernels<3>;

}  // namespace mpmvv::solver
