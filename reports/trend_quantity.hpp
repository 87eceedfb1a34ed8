#pragma once
#include <string>

#include "studies/claims/trend.hpp"

namespace mpmvv::reports {

/// The quantity of a trend, as its name has it: `l2` of an error or an extrapolated value, `cfl` of a limit. Empty for
/// orders, values of checks, and where the name has none.
std::string quantity_of(const claims::Trend& trend);

/// The trend's label with the unit behind its quantity: "error of 'linear' in l2 (m) at 64".
std::string label_with_unit(const claims::Trend& trend);

}  // namespace mpmvv::reports
