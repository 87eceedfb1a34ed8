#include "solver/kernels/block_kernels.hpp"

#include "solver/stencils/node_loop.hpp"

/// Compiled once for all pages.
namespace mpmvv::solver {

template Fault run_kernel(const EvaluateStress<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const EvaluateStress<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const EvaluateStress<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const EvaluateBodyForce<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const EvaluateBodyForce<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const EvaluateBodyForce<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const CheckDeformation<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const CheckDeformation<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const CheckDeformation<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const UpdateWidth<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const UpdateWidth<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const UpdateWidth<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const MoveByRate<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const MoveByRate<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const MoveByRate<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const SettlePosition<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const SettlePosition<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const SettlePosition<3>&, AnyBlock<3>&, const Grid<3>&);

}  // namespace mpmvv::solver
