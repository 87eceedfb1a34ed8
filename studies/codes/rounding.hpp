#pragma once
#include <vector>

#include "studies/codes/particle_table.hpp"

namespace mpmvv::codes {

/// How a file's numbers are rounded.
struct Rounding {
  int digits = 17;  ///< that they carry; of binary ones 7 and 16
  double unit = 0;  ///< of a point's last place, in the file's unit: RMS over the points of its length
};

/// That of the points with these coordinates. All columns of a text count, as a coordinate that does not change may
/// need few digits: it is rounded to as many digits as any number shows, or, where all coordinates show as many
/// decimals and no exponent, to these.
Rounding rounding_of(const ParticleTable& table, const std::vector<const TableColumn*>& coordinates);

/// RMS of the error that rounding alone makes of points with this unit: rounding errors are even within half a unit.
double rounding_error(double unit);

}  // namespace mpmvv::codes
