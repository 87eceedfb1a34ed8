#pragma once
#include <cstdint>

#include "solver/velocity_update/flip.hpp"

namespace mpmvv::solver {

/// v⁺ = m̃_k⁻¹ p⁺, V' = S v⁺, X' = X + Δt (V + V')/2, N table 1: grid velocities by the expanded inverse, those of the
/// stress updates too. With the consistent mass, v⁺ is its limit k -> infinity already.
struct Fmpm {
  static constexpr std::string_view word = "fmpm";
  int order = 2;              ///< k
  std::int64_t interval = 1;  ///< steps; those between are `flip` with second-order positions: periodic FMPM, N §3.1

  template <int D>
  VelocityFields<D> fields(Mpm<D>& s, double dt) const {
    if (!is_due(s)) return Flip{FlipPosition::second_order}.fields(s, dt);
    sharpen(s);
    return {.before = 0.5, .after = 0.5};
  }

  /// The lumped grid velocity becomes m̃_k⁻¹ p.
  template <int D>
  void sharpen(Mpm<D>& s) const {
    if (!is_due(s)) return;
    s.expand_inverse(order, s.grid().v);
    s.hold_expanded(s.grid().v);
  }

  /// Whether the step under way is one of its own.
  template <int D>
  bool is_due(const Mpm<D>& s) const {
    return s.steps() % interval == 0;
  }
};

}  // namespace mpmvv::solver
