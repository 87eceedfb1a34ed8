#pragma once
#include "solver/mpm.hpp"
#include "solver/velocity_update/update_particle.hpp"

namespace mpmvv::solver {

/// How the steps with a `+` end (N §2.3): the updated particle momenta are extrapolated to the grid once more, and the
/// last stress update, by `dt_stress`, takes the velocity found there,
///   v_p += Δt Σ_i N_ip a_i,   v̄_i = Σ_p N_ip m_p v_p / m_i,   F_p = (I + Δt_stress Σ_i v̄_i ⊗ ∇N_ip) F_p.
/// N does not say which shape functions; Sulsky, Zhou and Schreyer (1995) and Nairn's code keep those of the step's
/// start, and so does this. Positions follow v⁺, S (10). In N's notation v̄ = v + Δt S⁺S a where v⁺ = v + Δt a: what the
/// round trip S⁺S filters out of the acceleration never reaches F. With another velocity update V' and X' are its own,
/// and v̄ is m⁻¹ p, for `fmpm` m̃_k⁻¹ p, of those V'.
template <int D>
void update_with_remapped_velocity(Mpm<D>& s, double dt, double dt_stress) {
  auto& particles = s.particles();
  auto& grid = s.grid();

  const VelocityFields<D> fields = s.velocity_fields(dt);
  s.clear(grid.p);
  s.sweep(node_loop(UpdateVelocityAndRate<D>{particles, grid, fields}), node_loop(MapMomentum<D>{particles, grid}));
  s.fold_momentum();
  s.set_stress_velocity();

  s.sweep_and_settle(MoveByRate<D>{particles, dt},
                     UpdateDeformation<D>{particles, grid, s.deformation_step(dt_stress)});
}

}  // namespace mpmvv::solver
