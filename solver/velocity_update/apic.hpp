#pragma once
#include <string_view>

#include "solver/velocity_update/velocity_fields.hpp"

namespace mpmvv::solver {

/// V' = S v⁺, X' = X + Δt V', as `pic`. Particles also carry an affine field (see affine.hpp), which is zero at the
/// start. It keeps the part of linear fields that `pic` filters out. N §2.6, for comparison.
struct Apic : VelocityUpdate {
  static constexpr std::string_view word = "apic";
  static constexpr bool has_affine_field = true;

  template <int D>
  VelocityFields<D> prepare(Step<D>&, double) const {
    return {.after = 1};
  }
};

}  // namespace mpmvv::solver
