#include "solver/integrator/integrators.hpp"
#include "solver/kernels/map_to_grid.hpp"
#include "solver/stencils/node_loop.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

namespace {

/// v_p += Σ_i N_ip a_i Δt                                      W (18)
template <int D>
struct UpdateVelocity {
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;

  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    who.add(particles.v, (dt * nodes.gather(grid.a)).eval());
  }
};

/// x_p += Σ_i N_ip v_i Δt, and F_p by the same velocity        W (17), (10), (11)
template <int D>
struct UpdatePositionAndDeformation {
  static constexpr bool uses_gradients = true;
  Particles<D>& particles;
  const Grid<D>& grid;
  double dt;
  DeformationStep<D> deform;

  [[gnu::always_inline]] void operator()(const auto& who, const auto& nodes, const auto&) const {
    const auto v = nodes.gather_with_gradient(grid.v);
    who.add(particles.x, (dt * v.value).eval());
    who.set(particles.F, deform(who.of(particles.F), v.gradient));
  }
};

/// Update velocity first: the central difference with (47) replaced by W (51), the grid velocity mapped anew from the
/// updated particle velocities.
template <int D>
void uvf(Step<D>& s, double dt) {
  auto& particles = s.particles();
  auto& grid = s.grid();

  s.map_mass_and_forces();  // m_i; τ_p = τ(F_p), f_i                       W (8), (12), (14)
  s.set_acceleration();     // a_i = f_i / m_i                              W (15)

  s.clear(grid.p);
  s.sweep({UpdateVelocity<D>{particles, grid, dt},  // v_p                  W (18)
           MapMomentum<D>{particles, grid}});       // m_i, p_i             W (51)
  s.sum_momentum_images();
  s.set_velocity();  // v_i = p_i / m_i                                     W (51)

  s.sweep_and_settle(UpdatePositionAndDeformation<D>{particles, grid, dt, s.deformation(dt)});  // x_p, F_p
}

}  // namespace

Integrator uvf_integrator() {
  return {.word = "uvf", .in_1d = &uvf<1>, .in_2d = &uvf<2>, .in_3d = &uvf<3>, .is_staggered = true};
}

}  // namespace mpmvv::solver
