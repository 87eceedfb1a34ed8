#pragma once
#include <vector>

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
  using Field = std::vector<Padded<D>>;
  const Field* acceleration = nullptr;  ///< m/s²
  const Field* velocity = nullptr;      ///< m/s
  const Field* drift = nullptr;         ///< m/s
  double before = 0, after = 0;
};

}  // namespace mpmvv::solver
