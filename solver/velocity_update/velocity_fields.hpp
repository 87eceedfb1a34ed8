#pragma once
#include <cstdint>

#include "solver/array.hpp"
#include "solver/simd/padded.hpp"

namespace mpmvv::solver {

template <int D>
class Step;

/// What a velocity update makes of the grid's fields on a particle, task 4 of N table 1:
///   V' = V + Δt S `acceleration`, or S `velocity`, or where both are null S v,
///   X' = X + Δt (S `drift` + `before` V + `after` V'),
/// and the velocity gradient of task 5 is that of v. The fields are the grid's own.
template <int D>
struct VelocityFields {
  using Field = Array<Padded<D>>;
  const Field* acceleration = nullptr;  ///< m/s²
  const Field* velocity = nullptr;      ///< m/s
  const Field* drift = nullptr;         ///< m/s
  double before = 0, after = 0;

  bool include(const Field& field) const { return acceleration == &field || velocity == &field || drift == &field; }
};

/// What a velocity update is beside its `word`, its name in study files and on the command line, and its
/// fields(step, dt), asked for once the grid's v is that of the step's end. It declares anew what is otherwise for it.
struct VelocityUpdate {
  static constexpr bool adds_accelerations = false;     ///< particles keep their velocity and take an acceleration
  static constexpr bool takes_consistent_mass = false;  ///< is defined with the consistent mass, too
  static constexpr bool has_affine_field = false;       ///< particles carry the gradient of a field of their own
  int expansion_order() const { return 0; }             ///< terms of the expanded inverse that it takes
  /// Whether the step after so many expands the grid velocity itself, that of the stress updates, too.
  bool expands_grid_velocity(std::int64_t) const { return false; }
};

}  // namespace mpmvv::solver
