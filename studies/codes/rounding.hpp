#pragma once
#include <vector>

#include "studies/codes/particle_table.hpp"

namespace mpmvv::codes {

/// How the points in a file are rounded.
struct Rounding {
  int digits = 17;  ///< significant digits of the coordinates; 7 and 16 for binary numbers of 4 and 8 bytes
  double unit = 0;  ///< unit in the last place: RMS over points of its length as a vector, in the file's unit
};

/// Returns the rounding of the points with these coordinates. Coordinates in a text are rounded to the largest number
/// of digits that any column of the table shows, because a coordinate that does not change may need few. If all
/// coordinates show the same number of decimals and no exponent, they are rounded to these instead. This does not hold
/// if other columns show over two digits more and no coordinate is padded with zeros, as 0.2500 is: the texts may then
/// be short because the numbers are. Where hundreds of different ones are short, they were rounded to what they show.
Rounding rounding_of(const ParticleTable& table, const std::vector<const TableColumn*>& coordinates);

/// Returns the unit that the coordinates show by themselves, whatever the digits of other columns: the length of their
/// vector as above.
double unit_shown_by(const std::vector<const TableColumn*>& coordinates);

/// Returns the RMS error that rounding alone makes in points with this unit. Rounding errors are uniform within half a
/// unit, so it is unit/√12.
double rounding_error(double unit);

}  // namespace mpmvv::codes
