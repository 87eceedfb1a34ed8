#pragma once
#include "solver/integrator/remapped.hpp"

namespace mpmvv::solver {

/// Update stress last with re-extrapolated momenta, N §2.3: `usl` but for the velocity of the stress update.
template <int D>
void usl_plus(Mpm<D>& s, double dt) {
  auto& particles = s.particles();
  auto& grid = s.grid();

  s.clear_grid();
  s.sweep_with_forces(node_loop(), MapMomentum<D>{particles, grid});
  s.fold_momentum();
  s.set_grid_velocity();
  s.set_grid_acceleration();
  s.advance_grid_velocity(dt);

  update_with_remapped_velocity(s, dt, dt);
}

}  // namespace mpmvv::solver
