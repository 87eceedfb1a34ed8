#pragma once
#include <vector>

#include "solver/types.hpp"

namespace mpmvv::solver {

template <int D>
class Mpm;

/// What a velocity update makes of the grid's fields on a particle, task 4 of N table 1:
///   V' = V + S `added`, or S `taken`, or where both are null S v,
///   X' = X + Δt (S `drift` + `before` V + `after` V'),
/// and the velocity gradient of task 5 is that of v. Velocities, all of them; fields are on the grid.
template <int D>
struct VelocityFields {
  using Field = std::vector<Packed<D>>;
  const Field* added = nullptr;
  const Field* taken = nullptr;
  const Field* drift = nullptr;
  double before = 0, after = 0;
};

}  // namespace mpmvv::solver
