#include "solver/kernels/map_to_grid.hpp"

#include <tuple>

#include "solver/stencils/node_loop.hpp"
#include "solver/velocity_update/affine.hpp"

namespace mpmvv::solver {

/// Compiled once for all pages that map.
template <int D>
struct Maps {
  static constexpr std::tuple all{&run_kernel<D, MapMomentum<D>>, &run_kernel<D, MapForces<D>>,
                                  &run_kernel<D, Fused<MapMomentum<D>, MapForces<D>>>,
                                  &run_kernel<D, MapAffineMomentum<D>>};
};

template struct Maps<1>;
template struct Maps<2>;
template struct Maps<3>;

}  // namespace mpmvv::solver
