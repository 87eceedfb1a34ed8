#pragma once
#include <cstdint>

#include "solver/velocity_update/flip.hpp"

namespace mpmvv::solver {

/// v⁺ = m̃_k⁻¹ p⁺, V' = S v⁺, X' = X + Δt (V + V')/2, N table 1. Grid velocities come from the expanded inverse, also
/// those of the stress updates. With the consistent mass nothing is expanded: v⁺ = M̂⁻¹ p⁺ is near the limit
/// k -> infinity, which M⁻¹ p⁺ would be.
struct Fmpm : VelocityUpdate {
  static constexpr std::string_view word = "fmpm";
  static constexpr bool takes_consistent_mass = true;
  int order;              ///< k
  std::int64_t interval;  ///< in steps; steps between are `flip` with second-order positions: periodic FMPM, N §3.1

  explicit Fmpm(int k = 2, std::int64_t every = 1) : order(k), interval(every) {}

  int expansion_order() const { return order; }
  bool expands(std::int64_t steps) const { return steps % interval == 0; }
  bool expands_grid_velocity(std::int64_t steps) const { return expands(steps); }

  template <int D>
  VelocityFields<D> prepare(Step<D>& s, double dt) const {
    if (!expands(s.steps())) return Flip(FlipPosition::second_order).prepare(s, dt);
    s.expand_velocity();
    return {.before = 0.5, .after = 0.5};
  }
};

}  // namespace mpmvv::solver
