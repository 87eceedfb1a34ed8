#pragma once
#include "solver/mpm.hpp"
#include "solver/operations.hpp"

namespace mpmvv::solver {

/// Update stress averaged: N's task 5 done in both places, of `usf` and of `usl`, by half the time step each (N §2.3).
/// With FLIP both gradients belong to the one configuration x_p^n of the step, L = Σ_i v_i ⊗ ∇N_ip(x^n), so that
///   F' = (I + Δt/2 L(v)) F^n,   f = f(F'),   F^{n+1} = (I + Δt/2 L(v⁺)) F',
///   F^{n+1} = (I + Δt (L(v) + L(v⁺))/2 + Δt²/4 L(v⁺) L(v)) F^n:
/// the mean of the updates of usf and usl, and a product of their halves that neither has; its sum over a run is of
/// first order in Δt. So is what positions, S (10), and the body force, of t^n, bring in as in usf and usl. Energy: usf
/// keeps it, usl loses it to the part of a that the round trip S⁺S between particles and grid filters out, for
/// v⁺ = v + Δt a where the new particle velocities map to v + Δt S⁺S a; usavg loses half of that.
template <int D>
void usavg(Mpm<D>& s, double dt) {
  auto& particles = s.particles();
  auto& grid = s.grid();

  s.clear_grid();
  s.sweep(node_loop(MapMomentum<D>{particles, grid}));
  s.fold_momentum();
  s.update_stress_first(dt / 2, dt);
  s.update_particles(dt, dt / 2);
}

}  // namespace mpmvv::solver
