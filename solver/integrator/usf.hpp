#pragma once
#include "solver/mpm.hpp"

namespace mpmvv::solver {

/// Update stress first: W (8) to (18) in that order; deformation and stress from the mapped velocity, then the forces.
template <int D>
void usf(Mpm<D>& s, double dt) {
  auto& particles = s.particles();
  auto& grid = s.grid();

  grid.clear();
  s.sweep(node_loop(MapMomentum<D>{particles, grid}));
  s.fold(grid.p);
  s.set_grid_velocity();

  s.sweep_with_forces(node_loop(UpdateDeformation<D>{particles, grid, dt}));
  s.set_grid_acceleration();
  s.advance_grid_velocity(dt);

  s.sweep_and_settle(UpdateVelocity<D>{particles, grid, dt}, UpdatePosition<D>{particles, grid, dt});
}

}  // namespace mpmvv::solver
