#pragma once
#include "studies/cases/case.hpp"

namespace mpmvv::codes {

/// Whether the body force of a case is a planted mistake: misplaced or missing where the problem has one.
bool is_planted(const cases::Case& c);

}  // namespace mpmvv::codes
