#pragma once
#include <string>

#include "studies/codes/start_state.hpp"

namespace mpmvv::codes {

// The particles that a case starts with as a file: 17 digits, by which every number is told from its neighbours.

/// A header line and a line per particle, with columns for the coordinates that the problem has.
std::string csv_text(const StartState& state);

/// For ParaView, with three coordinates.
std::string vtu_text(const StartState& state);

/// The columns of `csv_text`: id, X, Y, x, y, v_x, v_y, m, V, F_xx, F_xy, F_yx, F_yy in the plane.
std::vector<std::string> start_columns(int dimension);

}  // namespace mpmvv::codes
