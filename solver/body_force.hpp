#pragma once
#include <cstdint>
#include <span>

#include "solver/types.hpp"

namespace mpmvv::solver {

/// The acceleration b due to body forces, m/s², which the caller of the solver supplies. The solver asks for it by
/// blocks of particles or by nodes, possibly from several threads at once, and for some particles more than once in a
/// step.
template <int D>
class BodyForce {
 public:
  virtual ~BodyForce() = default;

  /// Called by one thread before a sweep asks `on_particles` for b at time t.
  virtual void prepare(double) {}

  /// Writes b at time t of the particles with these ids (order of creation). X holds their reference positions, one for
  /// each id, or is empty where the scene's particles have none.
  virtual void on_particles(double t, std::span<const std::uint32_t> ids, std::span<const Vec<D>> X,
                            Vec<D>* b) const = 0;

  /// Returns b at time t at the current position x. Used where the scene takes the body force on the grid, for each
  /// node with enough mass, ghosts included: so x may lie beyond a face of the domain. Along a periodic axis b must
  /// have the period of the domain, and at a mirror it must be its own mirror image.
  virtual Vec<D> at_position(const Vec<D>& x, double t) const = 0;
};

}  // namespace mpmvv::solver
