#include "solver/integrator/integrators.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

namespace {

/// Advances the grid velocity to the end of the step.
template <int D>
void advance_grid(Step<D>& s, double dt) {
  s.map_momentum_and_forces();  // m_i, p_i; τ_p = τ(F_p), f_i         S (1), (3), (4), (16), W (8), (12), (14)
  s.set_velocity();             // v_i = p_i / m_i                     S (2), W (9)
  s.set_acceleration();         // a_i = f_i / m_i                     S (5), W (15)
  s.advance_velocity(dt);       // v_i⁺ = v_i + Δt a_i                 S (6), W (16)
}

/// Update stress last: S (1) to (10), W (8), (9), (14) to (19), then (11). With particle velocities half a step behind
/// it is `cd`, the staggered central difference, S (11) to (15), W (40) to (50). With `fmpm` it is N table 1.
template <int D>
void usl(Step<D>& s, double dt) {
  advance_grid(s, dt);
  s.update_particles(dt, s.deformation(dt));  // v_p, x_p; F_p by v⁺      S (7) to (10), W (17) to (19), (11)
}

/// Update stress last with re-extrapolated momenta, N §2.3: the updated particle momenta are mapped once more, and F
/// follows the velocity v̄ of these,
///   v_p += Δt Σ_i N_ip a_i,   v̄_i = Σ_p N_ip m_p v_p / m_i,   F_p = (I + Δt Σ_i v̄_i ⊗ ∇N_ip) F_p.
/// N does not say with which shape functions; Sulsky, Zhou and Schreyer (1995) and Nairn's code keep those of the
/// step's start, and so does this. Positions follow v⁺, S (10). In N's notation v̄ = v + Δt S⁺S a, whereas
/// v⁺ = v + Δt a: the part of the acceleration that the product S⁺S filters out never reaches F. Other velocity updates
/// than FLIP set V' and X' in their own way; v̄ is then m⁻¹ p of those V', or m̃_k⁻¹ p for `fmpm`.
template <int D>
void usl_plus(Step<D>& s, double dt) {
  advance_grid(s, dt);
  s.update_velocities_and_map_momentum(dt);            // v_p, (x_p' - x_p)/Δt; p_i
  s.set_stress_velocity();                             // v̄_i
  s.move_particles_and_deform(dt, s.deformation(dt));  // x_p; F_p by v̄
}

}  // namespace

Integrator usl_integrator() {
  return {.word = "usl", .in_1d = &usl<1>, .in_2d = &usl<2>, .in_3d = &usl<3>};
}

Integrator cd_integrator() {
  return {.word = "cd", .in_1d = &usl<1>, .in_2d = &usl<2>, .in_3d = &usl<3>, .is_staggered = true};
}

Integrator usl_plus_integrator() {
  return {.word = "usl+", .in_1d = &usl_plus<1>, .in_2d = &usl_plus<2>, .in_3d = &usl_plus<3>, .is_remapped = true};
}

}  // namespace mpmvv::solver
