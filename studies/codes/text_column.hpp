#pragma once
#include <string_view>

#include "studies/codes/particle_table.hpp"

namespace mpmvv::codes {

/// Adds a number as a text has it, and to the column how many digits that shows: 1.5e-3, .5, +2, nan, inf, and 1.5D-3
/// as Fortran writes it. False, and nothing added, when it is none.
bool add_text(TableColumn& column, std::string_view text);

}  // namespace mpmvv::codes
