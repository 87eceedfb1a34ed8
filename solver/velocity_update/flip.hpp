#pragma once
#include <string_view>

#include "solver/velocity_update/velocity_fields.hpp"

namespace mpmvv::solver {

/// How positions follow with FLIP, V' = V + Δt S a, in which particles keep their velocity and take the grid's
/// acceleration.
enum class FlipPosition {
  first_order,   ///< X' = X + Δt S v⁺                    S (10), W (17)
  second_order,  ///< X' = X + Δt S (v + Δt a/2)          N §2.3, where the last term is printed with Δt for Δt²
  particle       ///< X' = X + Δt (V + V')/2              N §2.3: "very poor results"
};

struct Flip : VelocityUpdate {
  static constexpr std::string_view word = "flip";
  static constexpr bool adds_accelerations = true, takes_consistent_mass = true;
  FlipPosition position;

  explicit Flip(FlipPosition follow = FlipPosition::first_order) : position(follow) {}

  bool needs_whole_steps() const { return position != FlipPosition::first_order; }

  template <int D>
  VelocityFields<D> prepare(Step<D>& s, double dt) const {
    auto& grid = s.grid();
    if (position == FlipPosition::particle) return {.acceleration = &grid.a, .before = 0.5, .after = 0.5};
    if (position == FlipPosition::first_order) return {.acceleration = &grid.a, .drift = &grid.v};
    s.for_nodes([&](std::size_t n) { grid.f[n] = grid.v[n] - 0.5 * dt * grid.a[n]; });  // forces are no longer needed
    return {.acceleration = &grid.a, .drift = &grid.f};
  }
};

}  // namespace mpmvv::solver
