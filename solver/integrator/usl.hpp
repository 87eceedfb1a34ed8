#pragma once
#include "solver/mpm.hpp"
#include "solver/operations.hpp"

namespace mpmvv::solver {

/// Update stress last: S (1) to (10), W (8), (9), (14) to (19). With particle velocities half a step behind it is the
/// staggered central difference, S (11) to (15), W (40) to (50). N table 1 with its velocity update.
template <int D>
void usl(Mpm<D>& s, double dt) {
  auto& particles = s.particles();
  auto& grid = s.grid();

  s.clear_grid();
  s.sweep_with_forces(node_loop(), MapMomentum<D>{particles, grid});
  s.fold_momentum();
  s.set_grid_velocity();
  s.set_grid_acceleration();
  s.advance_grid_velocity(dt);

  s.update_particles(dt, dt);
}

}  // namespace mpmvv::solver
