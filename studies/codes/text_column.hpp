#pragma once
#include <string_view>

#include "studies/codes/particle_table.hpp"

namespace mpmvv::codes {

/// Appends the number in a text to the column, and notes how many digits the text shows: 1.5e-3, .5, +2, nan,
/// inf, and 1.5D-3 as Fortran writes it. Returns false and adds nothing if the text is no number.
bool add_text(TableColumn& column, std::string_view text);

}  // namespace mpmvv::codes
