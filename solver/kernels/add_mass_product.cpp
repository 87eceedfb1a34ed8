#include "solver/kernels/add_mass_product.hpp"

#include "solver/stencils/node_loop.hpp"

/// Compiled once for all that multiply.
namespace mpmvv::solver {

template Fault run_kernel(const AddMassProduct<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const AddMassProduct<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const AddMassProduct<3>&, AnyBlock<3>&, const Grid<3>&);

template Fault run_kernel(const AddScalarMassProduct<1>&, AnyBlock<1>&, const Grid<1>&);
template Fault run_kernel(const AddScalarMassProduct<2>&, AnyBlock<2>&, const Grid<2>&);
template Fault run_kernel(const AddScalarMassProduct<3>&, AnyBlock<3>&, const Grid<3>&);

}  // namespace mpmvv::solver
