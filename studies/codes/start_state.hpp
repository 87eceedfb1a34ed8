#pragma once
#include <cstdint>
#include <vector>

#include "studies/cases/case.hpp"
#include "studies/codes/snapshot.hpp"

namespace mpmvv::codes {

/// The particles with which a case starts, in the order in which it starts with them. SI units. Beyond the problem's
/// dimension the components of X, x and v are 0, and those of F are those of the identity; volume and mass are then per
/// metre, or per square metre, across the axes that the problem lacks. Of a body at rest all velocities are exactly 0.
struct StartState {
  int dimension = 0;
  std::vector<std::int64_t> id;  ///< 1, 2, ... in the order in which they fill the body
  std::vector<Point> X, x, v;    ///< reference position, position, velocity; with start `exact` v is that at t = -Δt/2
  std::vector<double> m, V;      ///< mass and reference volume
  std::vector<Tensor> F;         ///< deformation gradient

  std::size_t size() const { return id.size(); }
};

StartState start_state(const cases::Case& c);

// Whether all velocities are 0, or all F the identity, up to round-off: the start that codes without an initial
// velocity, or deformation, can take.
bool is_at_rest(const StartState& state, double wave_speed);
bool is_undeformed(const StartState& state);

}  // namespace mpmvv::codes
