#pragma once
#include <string>

#include "studies/codes/start_state.hpp"

namespace mpmvv::codes {

// The particles with which a case starts, as the text of a file. Numbers have 17 digits, so that they read back
// exactly.

/// Returns a header line and a line per particle, with columns for the coordinates that the problem has.
std::string csv_text(const StartState& state);

/// Returns a VTU file for ParaView, with three coordinates.
std::string vtu_text(const StartState& state);

/// Returns the columns of `csv_text`: id, X, Y, x, y, v_x, v_y, m, V, F_xx, F_xy, F_yx, F_yy in the plane.
std::vector<std::string> start_columns(int dimension);

}  // namespace mpmvv::codes
