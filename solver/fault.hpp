#pragma once

namespace mpmvv::solver {

/// Why a run has blown up. The values are bits, since several particles can fail in one sweep.
enum class Fault : unsigned {
  none = 0,
  outside = 1,   ///< some nodes of a particle are not in the grid, or its position is NaN
  outgrown = 2,  ///< a width is not in (0, h], a corner is more than `domain_reach` cells from its particle, or NaN
  inverted = 4   ///< det F <= 0, or NaN
};

constexpr Fault operator|(Fault a, Fault b) {
  return static_cast<Fault>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool contains(Fault faults, Fault one) {
  return (static_cast<unsigned>(faults) & static_cast<unsigned>(one)) != 0;
}

}  // namespace mpmvv::solver
