#include "solver/kernels/update_particles.hpp"

#include "solver/stencils/node_loop.hpp"

/// Compiled once for all pages that update particles.
namespace mpmvv::solver {

template Fault run_kernel(const UpdateDeformation<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const UpdateDeformation<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const UpdateDeformation<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const UpdateParticle<1, false>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const UpdateParticle<1, true>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const UpdateParticle<2, false>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const UpdateParticle<2, true>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const UpdateParticle<3, false>&, AnyBlock<3>&, const Grid<3>&);
template Fault run_kernel(const UpdateParticle<3, true>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const UpdateVelocityAndPosition<1, false>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const UpdateVelocityAndPosition<1, true>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const UpdateVelocityAndPosition<2, false>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const UpdateVelocityAndPosition<2, true>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const UpdateVelocityAndPosition<3, false>&, AnyBlock<3>&, const Grid<3>&);
template Fault run_kernel(const UpdateVelocityAndPosition<3, true>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const UpdateVelocityAndRate<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const UpdateVelocityAndRate<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const UpdateVelocityAndRate<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const UpdateVelocity<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const UpdateVelocity<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const UpdateVelocity<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const UpdatePositionAndDeformation<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const UpdatePositionAndDeformation<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const UpdatePositionAndDeformation<3>&, AnyBlock<3>&, const Grid<3>&);

}  // namespace mpmvv::solver
