#pragma once
#include <string>

#include "studies/records/result.hpp"

namespace mpmvv::claims {

/// "0.93 to 1.6", with as many digits as tell the ends apart; "without bounds"; empty for less than round-off.
std::string range_text(double lower, double upper);

/// What stands behind a number that was found: " ± 0.21" of an order, " (0.93 to 1.6)" of what times or replicates
/// make, " or less" of a limit below all that was tried, and its remark, " (finest segment 1.42)". Empty without an
/// interval and a remark. The bracket of a limit stands in its name.
std::string interval_text(const records::ClaimPart& part, const records::Found& found);

}  // namespace mpmvv::claims
