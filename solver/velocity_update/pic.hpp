#pragma once
#include <string_view>

#include "solver/velocity_update/velocity_fields.hpp"

namespace mpmvv::solver {

/// V' = S v⁺, X' = X + Δt V': particles take the grid's velocity, N (2), third row.
struct Pic : VelocityUpdate {
  static constexpr std::string_view word = "pic";

  template <int D>
  VelocityFields<D> prepare(Step<D>&, double) const {
    return {.after = 1};
  }
};

}  // namespace mpmvv::solver
