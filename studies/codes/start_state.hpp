#pragma once
#include <cstdint>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/codes/snapshot.hpp"

namespace mpmvv::codes {

/// The particles with which a case starts, in the order in which it starts with them. SI units. Of coordinates beyond
/// the problem's dimension X, x and v are 0, and F is that of the identity; volume and mass are then per metre (or
/// square metre) across.
struct StartState {
  int dimension = 0;
  std::vector<std::int64_t> id;  ///< 1, 2, ... in the order in which they fill the body
  std::vector<Point> X, x, v;    ///< reference position, position, velocity; v is that of -Δt/2 with start `exact`
  std::vector<double> m, V;      ///< mass and reference volume
  std::vector<Tensor> F;         ///< deformation gradient

  std::size_t size() const { return id.size(); }
};

StartState start_state(const cases::Case& c);

// Up to round-off, for codes that take no velocity, or no deformation, to start with.
bool is_at_rest(const StartState& state, double wave_speed);
bool is_undeformed(const StartState& state);

}  // namespace mpmvv::codes
