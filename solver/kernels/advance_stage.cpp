#include "solver/kernels/advance_stage.hpp"

#include "solver/stencils/node_loop.hpp"

namespace mpmvv::solver {

template Fault run_kernel(const AdvanceStage<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const AdvanceStage<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const AdvanceStage<3>&, AnyBlock<3>&, const Grid<3>&);

}  // namespace mpmvv::solver
