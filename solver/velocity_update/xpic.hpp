#pragma once
#include <string_view>

#include "solver/velocity_update/velocity_fields.hpp"

namespace mpmvv::solver {

/// V' = S (m̃_k⁻¹ p + Δt a), X' = X + Δt (S v + (V' - V)/2), N §2.3: particle velocities lose the part that the grid
/// does not see, then follow FLIP with lumped masses.
struct Xpic : VelocityUpdate {
  static constexpr std::string_view word = "xpic";
  int order;  ///< k

  explicit Xpic(int k = 2) : order(k) {}

  int expansion_order() const { return order; }
  bool expands(std::int64_t) const { return true; }

  /// Overwrites the grid's forces and accelerations, which are no longer needed: f then holds m̃_k⁻¹ p + Δt a, and a
  /// holds v.
  template <int D>
  VelocityFields<D> prepare(Step<D>& s, double dt) const {
    auto& grid = s.grid();
    s.for_nodes([&](std::size_t n) { grid.f[n] = grid.v[n] - dt * grid.a[n]; });
    s.expand_inverse(grid.f);
    s.for_nodes([&](std::size_t n) {
      const Padded<D> increment = dt * grid.a[n];
      grid.f[n] += increment;
      grid.a[n] = grid.v[n] - increment;
    });
    s.hold_after_expansion(grid.f);
    return {.velocity = &grid.f, .drift = &grid.a, .before = -0.5, .after = 0.5};
  }
};

}  // namespace mpmvv::solver
