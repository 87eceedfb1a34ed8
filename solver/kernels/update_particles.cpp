#include "solver/kernels/update_particles.hpp"

#include <tuple>

#include "solver/kernels/advance_stage.hpp"
#include "solver/stencils/node_loop.hpp"
#include "solver/velocity_update/affine.hpp"

namespace mpmvv::solver {

/// Compiled once for all pages that update particles.
template <int D>
struct ParticleUpdates {
  static constexpr std::tuple all{&run_kernel<D, EvaluateVelocityGradient<D>>,
                                  &run_kernel<D, UpdateParticle<D, false>>,
                                  &run_kernel<D, UpdateParticle<D, true>>,
                                  &run_kernel<D, UpdateVelocityAndPosition<D, false>>,
                                  &run_kernel<D, UpdateVelocityAndPosition<D, true>>,
                                  &run_kernel<D, UpdateVelocityAndRate<D>>,
                                  &run_kernel<D, UpdateVelocity<D>>,
                                  &run_kernel<D, UpdatePosition<D>>,
                                  &run_kernel<D, UpdateAffineField<D>>,
                                  &run_kernel<D, AdvanceStage<D>>};
};

template struct ParticleUpdates<1>;
template struct ParticleUpdates<2>;
template struct ParticleUpdates<3>;

}  // namespace mpmvv::solver
