#include "solver/integrator/integrators.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

namespace {

/// Makes the first half of the stress update, and advances the grid velocity to the end of the step.
template <int D>
void deform_half_way_and_advance_grid(Step<D>& s, double dt) {
  s.map_momentum();                                // m_i, p_i
  s.set_stress_velocity();                         // v_i = p_i / m_i
  s.deform_and_map_forces(s.deformation(dt / 2));  // F_p' by v; τ_p = τ(F_p'), f_i
  s.restore_velocity();                            // v_i = p_i / m_i, where F followed another v_i
  s.set_acceleration();                            // a_i = f_i / m_i
  s.advance_velocity(dt);                          // v_i⁺ = v_i + Δt a_i
}

/// Update stress averaged, N §2.3: task 5 is done in both places, where `usf` and where `usl` does it, over half the
/// time step each. With FLIP both gradients are those at the positions x_p^n of the step's start,
/// L = Σ_i v_i ⊗ ∇N_ip(x^n), so that
///   F' = (I + Δt/2 L(v)) F^n,   f = f(F'),   F^{n+1} = (I + Δt/2 L(v⁺)) F',
///   F^{n+1} = (I + Δt (L(v) + L(v⁺))/2 + Δt²/4 L(v⁺) L(v)) F^n:
/// the mean of the updates of usf and usl, and a product of their halves that neither has. The sum of this product over
/// a run is of first order in Δt. So are the errors from positions, S (10), and from the body force, which is that of
/// t^n; usf and usl have these, too.
///
/// Energy, for small motions that cross no knots: that of usf does not drift; its error oscillates and is of first
/// order in Δt. usl loses energy to the part of a that the product S⁺S of both mappings filters out, because
/// v⁺ = v + Δt a, whereas the new particle velocities map to v + Δt S⁺S a. usavg loses half as much as usl.
template <int D>
void usavg(Step<D>& s, double dt) {
  deform_half_way_and_advance_grid(s, dt);
  s.update_particles(dt, s.deformation(dt / 2));  // v_p, x_p; F_p by v⁺
}

/// Update stress averaged with re-extrapolated momenta, N §2.3: `usavg`, except that the velocity of the second half is
/// that of `usl+`. For small motions this is leapfrog in (v, F), half drift, kick, half drift: the oscillating energy
/// errors of usf and usl+, of first order and opposite sign, cancel.
template <int D>
void usavg_plus(Step<D>& s, double dt) {
  deform_half_way_and_advance_grid(s, dt);
  s.update_velocities_and_map_momentum(dt);                // v_p, (x_p' - x_p)/Δt; p_i
  s.set_stress_velocity();                                 // v̄_i
  s.move_particles_and_deform(dt, s.deformation(dt / 2));  // x_p; F_p by v̄
}

}  // namespace

Integrator usavg_integrator() {
  return {.word = "usavg", .in_1d = &usavg<1>, .in_2d = &usavg<2>, .in_3d = &usavg<3>, .share_after_stress = 0.5};
}

Integrator usavg_plus_integrator() {
  return {.word = "usavg+",
          .in_1d = &usavg_plus<1>,
          .in_2d = &usavg_plus<2>,
          .in_3d = &usavg_plus<3>,
          .is_remapped = true,
          .share_after_stress = 0.5};
}

}  // namespace mpmvv::solver
