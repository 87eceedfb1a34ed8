#pragma once
#include <tuple>

#include "solver/kernels/add_mass_product.hpp"
#include "solver/kernels/advance_stage.hpp"
#include "solver/kernels/block_kernels.hpp"
#include "solver/kernels/map_to_grid.hpp"
#include "solver/kernels/update_particles.hpp"
#include "solver/stencils/node_loop.hpp"
#include "solver/velocity_update/affine.hpp"

namespace mpmvv::solver {

/// All kernels but AddCouplings (mass_matrix.cpp), compiled once for all files that run them. Each D has a file that
/// instantiates them, because those in space are compiled for more registers where the processor has them
/// (cmake/Flags.cmake).
template <int D>
struct Compiled {
  static constexpr std::tuple kernels{&run_kernel<D, MapMomentum<D>>,
                                      &run_kernel<D, MapForces<D>>,
                                      &run_kernel<D, Fused<MapMomentum<D>, MapForces<D>>>,
                                      &run_kernel<D, MapAffineMomentum<D>>,
                                      &run_kernel<D, AddMassProduct<D>>,
                                      &run_kernel<D, AddMassProduct<D, Padded<D + 1>>>,
                                      &run_kernel<D, EvaluateVelocityGradient<D>>,
                                      &run_kernel<D, UpdateParticle<D, false>>,
                                      &run_kernel<D, UpdateParticle<D, true>>,
                                      &run_kernel<D, UpdateVelocityAndPosition<D, false>>,
                                      &run_kernel<D, UpdateVelocityAndPosition<D, true>>,
                                      &run_kernel<D, UpdateVelocityAndRate<D>>,
                                      &run_kernel<D, UpdateVelocity<D>>,
                                      &run_kernel<D, UpdatePosition<D>>,
                                      &run_kernel<D, UpdateAffineField<D>>,
                                      &run_kernel<D, AdvanceStage<D>>,
                                      &run_kernel<D, EvaluateStress<D>>,
                                      &run_kernel<D, EvaluateBodyForce<D>>,
                                      &run_kernel<D, UpdateDeformation<D>>,
                                      &run_kernel<D, CheckDeformation<D>>,
                                      &run_kernel<D, UpdateWidth<D>>,
                                      &run_kernel<D, MoveByRate<D>>,
                                      &run_kernel<D, WrapPosition<D>>};
};

}  // namespace mpmvv::solver
