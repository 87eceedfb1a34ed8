#pragma once
#include <string>
#include <vector>

#include "mms/expression/dialect.hpp"
#include "studies/cases/case.hpp"

namespace mpmvv::codes {

/// How the wall at a face moves along its axis, m and m/s, as expressions of t. Empty where the face has no wall, or
/// where they cannot be written.
struct WallExpressions {
  std::string position, velocity;
};

/// Returns the motions of the walls of a case by face: xmin, xmax, ymin, ...
std::vector<WallExpressions> wall_expressions(const cases::Case& c, const mms::expression::Dialect& dialect);

}  // namespace mpmvv::codes
