#pragma once
#include "studies/codes/output_checks.hpp"

/// Checks that displacements are what they should be: x - X. A function `require_...` throws an OutputFault if they
/// fail.
namespace mpmvv::codes {

/// Requires that displacements are x - X, the shortest such vector in a periodic grid, if the file has all three: for
/// each particle to its digits and 1e-6 of the grid's diagonal, or of |x|.
template <int D>
void require_same_displacements(const MatchedEnd<D>& end);

/// Requires that displacements count from the position at rest. Where their error is more than a fiftieth of the
/// displacements, they must not fit the exact solution ten times better together with the displacement at time zero.
template <int D>
void require_displacements_from_rest(const MatchedEnd<D>& end);

}  // namespace mpmvv::codes
