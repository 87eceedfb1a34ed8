#include "solver/kernels/add_mass_product.hpp"

#include <tuple>

#include "solver/stencils/node_loop.hpp"

namespace mpmvv::solver {

/// Compiled once for all that multiply.
template <int D>
struct MassProducts {
  static constexpr std::tuple all{&run_kernel<D, AddMassProduct<D>>, &run_kernel<D, AddMassProduct<D, Padded<D + 1>>>};
};

template struct MassProducts<1>;
template struct MassProducts<2>;
template struct MassProducts<3>;

}  // namespace mpmvv::solver
