#pragma once
#include <cstdint>

#include "solver/array.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

template <int D>
class Step;

/// The grid's fields and the factors by which a velocity update advances a particle, N §2.3, task 4:
///   V' = V + Δt S `acceleration`, or S `velocity`, or S v where both are null,
///   X' = X + Δt (S `drift` + `before` V + `after` V'),
/// without the first term where `drift` is null. The velocity gradient of task 5 is that of v. The fields are the
/// grid's own.
template <int D>
struct VelocityFields {
  using Field = Array<Padded<D>>;
  const Field* acceleration = nullptr;  ///< m/s²
  const Field* velocity = nullptr;      ///< m/s
  const Field* drift = nullptr;         ///< m/s
  double before = 0, after = 0;

  bool include(const Field& field) const { return acceleration == &field || velocity == &field || drift == &field; }
};

/// The base of velocity updates: the properties that they have unless they redeclare them. Besides these a velocity
/// update has a `word`, its name in study files and on the command line, and prepare(step, dt), which returns its
/// `VelocityFields` when the grid's v is that of the step's end. To make them it may overwrite v, a and f on the grid.
struct VelocityUpdate {
  static constexpr bool adds_accelerations = false;     ///< particles keep their velocity and add an acceleration
  static constexpr bool takes_consistent_mass = false;  ///< is defined with the consistent mass, too
  static constexpr bool has_affine_field = false;       ///< particles carry the gradient of an affine velocity field
  /// Whether it goes with integrators that have whole steps alone (`Integrator::has_whole_steps`).
  bool needs_whole_steps() const { return true; }
  int expansion_order() const { return 0; }  ///< number of terms of the expanded inverse; 0: it takes none
  /// Whether the step after this number of finished ones applies the expanded inverse.
  bool expands(std::int64_t) const { return false; }
  /// Whether that step expands the grid velocity itself, also for the stress updates.
  bool expands_grid_velocity(std::int64_t) const { return false; }
};

}  // namespace mpmvv::solver
