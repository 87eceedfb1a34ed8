#pragma once
#include "solver/integrator/remapped.hpp"

namespace mpmvv::solver {

/// Update stress averaged with re-extrapolated momenta, N §2.3: `usavg` but for the velocity of the second half. For
/// small motions that is leapfrog in (v, F), half drift, kick, half drift: the energy errors of usf and usl+, of first
/// order and opposite sign, cancel.
template <int D>
void usavg_plus(Mpm<D>& s, double dt) {
  auto& particles = s.particles();
  auto& grid = s.grid();

  s.clear_grid();
  s.sweep(node_loop(MapMomentum<D>{particles, grid}));
  s.fold_momentum();
  s.update_stress_first(dt / 2, dt);
  update_with_remapped_velocity(s, dt, dt / 2);
}

}  // namespace mpmvv::solver
