#include "solver/integrator/integrators.hpp"
#include "solver/kernels/map_to_grid.hpp"
#include "solver/kernels/update_particles.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

namespace {

/// Update velocity first: the central difference with W (47) replaced by W (51), in which the grid velocity is mapped
/// anew from the updated particle velocities.
template <int D>
void uvf(Step<D>& s, double dt) {
  s.map_momentum_and_forces();  // m_i; τ_p = τ(F_p), f_i                   W (8), (12), (14)
  s.set_acceleration();         // a_i = f_i / m_i                          W (15)

  auto& particles = s.particles();
  auto& grid = s.grid();
  s.clear(grid.p);
  s.sweep({UpdateVelocity<D>{particles, grid, dt},  // v_p                  W (18)
           MapMomentum<D>{particles, grid}});       // m_i, p_i             W (51)
  s.sum_momentum_images();
  s.set_velocity();  // v_i = p_i / m_i                                     W (51)

  s.last_sweep(UpdatePosition<D>{particles, grid, dt},               // x_p; L_p by v           W (17), (10)
               UpdateDeformation<D>{particles, s.deformation(dt)});  // F_p                      W (11)
}

}  // namespace

Integrator uvf_integrator() {
  return {.word = "uvf",
          .in_1d = &uvf<1>,
          .in_2d = &uvf<2>,
          .in_3d = &uvf<3>,
          .is_staggered = true,
          .is_accelerated_first = true};
}

}  // namespace mpmvv::solver
