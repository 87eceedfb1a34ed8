#pragma once
#include <cstdint>
#include <span>

#include "solver/types.hpp"

namespace mpmvv::solver {

/// The acceleration b due to body forces, as the caller of the solver supplies it. Called for blocks of particles, for
/// some of them more than once, possibly from several threads at once.
template <int D>
class BodyForce {
 public:
  virtual ~BodyForce() = default;

  /// Called before the blocks of a sweep ask for time t, by one thread.
  virtual void prepare(double) {}

  /// b at time t of the particles with these ids (order of creation) and reference positions: one to each id, or none
  /// at all where the scene's particles have none.
  virtual void on_particles(double t, std::span<const std::uint32_t> ids, std::span<const Vec<D>> X,
                            Vec<D>* b) const = 0;

  /// b at the current position x, for forces taken on the grid.
  virtual Vec<D> at_position(const Vec<D>& x, double t) const = 0;
};

}  // namespace mpmvv::solver
