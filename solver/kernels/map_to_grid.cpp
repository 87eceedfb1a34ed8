#include "solver/kernels/map_to_grid.hpp"

#include "solver/stencils/node_loop.hpp"

/// Compiled once for all pages that map.
namespace mpmvv::solver {

template Fault run_kernel(const MapMomentum<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const MapMomentum<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const MapMomentum<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const MapForces<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const MapForces<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const MapForces<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const Fused<MapMass<1>, MapForces<1>>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const Fused<MapMass<2>, MapForces<2>>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const Fused<MapMass<3>, MapForces<3>>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const Fused<MapMomentum<1>, MapForces<1>>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const Fused<MapMomentum<2>, MapForces<2>>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const Fused<MapMomentum<3>, MapForces<3>>&, AnyBlock<3>&, const Grid<3>&);

}  // namespace mpmvv::solver
