#include "solver/integrator/integrators.hpp"
#include "solver/step.hpp"

namespace mpmvv::solver {

namespace {

/// Update stress first: W (8) to (18) in that order. F and stress follow the mapped velocity, then forces are mapped.
template <int D>
void usf(Step<D>& s, double dt) {
  s.map_momentum();                            // m_i, p_i                            W (8), (9)
  s.set_stress_velocity();                     // v_i = p_i / m_i                     W (9)
  s.deform_and_map_forces(s.deformation(dt));  // F_p by v; τ_p = τ(F_p), f_i         W (10) to (14)
  s.restore_velocity();                        // v_i = p_i / m_i, where F followed another v_i
  s.set_acceleration();                        // a_i = f_i / m_i                     W (15)
  s.advance_velocity(dt);                      // v_i⁺ = v_i + Δt a_i                 W (16)
  s.update_particles(dt);                      // v_p, x_p                            W (17), (18)
}

}  // namespace

Integrator usf_integrator() {
  return {.word = "usf", .in_1d = &usf<1>, .in_2d = &usf<2>, .in_3d = &usf<3>, .share_after_stress = 0};
}

}  // namespace mpmvv::solver
