#pragma once
#include "studies/codes/output_checks.hpp"

/// The stresses of an output, and checks of them. A function `require_...` throws an OutputFault if they fail.
namespace mpmvv::codes {

/// Requires stresses that are numbers. A study that compares their errors would otherwise find a gap and no reason.
void require_stresses(const Snapshot& end);

/// Requires that stresses, if the file has any, are in Pa, and positive in tension: RMS over the particles not about a
/// thousand, a million or 1e9 times the exact ones, or so many times smaller, to a factor of three. Where the exact
/// ones are small at the end, nothing is required; nor is their sign where displacements are off by more than a
/// quarter.
template <int D>
void require_stress_units(const MatchedEnd<D>& end);

/// Returns the RMS over the particles of |σ - σ(X, T)|, in Pa. The file has to have stresses.
template <int D>
double stress_error(const MatchedEnd<D>& end);

}  // namespace mpmvv::codes
