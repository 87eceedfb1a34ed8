#pragma once
#include "solver/mpm.hpp"
#include "solver/operations.hpp"

namespace mpmvv::solver {

/// Update velocity first: the central difference with (47) replaced by W (51), the grid velocity mapped anew from the
/// updated particle velocities.
template <int D>
void uvf(Mpm<D>& s, double dt) {
  auto& particles = s.particles();
  auto& grid = s.grid();

  s.clear_grid();
  s.sweep_with_forces(node_loop(), MapMass<D>{particles, grid});
  s.fold_momentum();
  s.set_grid_acceleration();

  s.clear(grid.p);
  s.sweep(node_loop(UpdateVelocity<D>{particles, grid, dt}), node_loop(MapMomentum<D>{particles, grid}));
  s.fold_momentum();
  s.set_grid_velocity();

  s.sweep_and_settle(UpdatePositionAndDeformation<D>{particles, grid, dt, s.deformation_step(dt)});
}

}  // namespace mpmvv::solver
