#pragma once
#include <string_view>

#include "solver/velocity_update/velocity_fields.hpp"

namespace mpmvv::solver {

/// V' = V + Δt S a: particles keep their velocity and take the grid's acceleration. How positions follow:
enum class FlipPosition {
  first_order,   ///< X' = X + Δt S v⁺                    S (10), W (17)
  second_order,  ///< X' = X + Δt S (v + Δt a/2)          N §2.3, where the last term is printed with Δt for Δt²
  particle       ///< X' = X + Δt (V + V')/2              N §2.3: "very poor results"
};

struct Flip {
  static constexpr std::string_view word = "flip";
  FlipPosition position = FlipPosition::first_order;

  /// f and a have served: they hold Δt a and v + Δt a/2 afterwards.
  template <int D>
  VelocityFields<D> fields(Mpm<D>& s, double dt) const {
    auto& grid = s.grid();
    s.for_nodes([&](std::size_t n) {
      grid.f[n] = dt * grid.a[n];
      grid.a[n] = grid.v[n] - 0.5 * grid.f[n];
    });
    if (position == FlipPosition::particle) return {.added = &grid.f, .before = 0.5, .after = 0.5};
    if (position == FlipPosition::second_order) return {.added = &grid.f, .drift = &grid.a};
    return {.added = &grid.f, .drift = &grid.v};
  }
};

}  // namespace mpmvv::solver
