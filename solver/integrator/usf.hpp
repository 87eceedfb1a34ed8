#pragma once
#include "solver/mpm.hpp"
#include "solver/operations.hpp"

namespace mpmvv::solver {

/// Update stress first: W (8) to (18) in that order; deformation and stress from the mapped velocity, then the forces.
template <int D>
void usf(Mpm<D>& s, double dt) {
  auto& particles = s.particles();
  auto& grid = s.grid();

  s.clear_grid();
  s.sweep(node_loop(MapMomentum<D>{particles, grid}));
  s.fold_momentum();
  s.update_stress_first(dt, dt);
  s.update_particles(dt, 0);
}

}  // namespace mpmvv::solver
