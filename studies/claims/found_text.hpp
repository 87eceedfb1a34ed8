#pragma once
#include <string>
#include <utility>

#include "studies/records/result.hpp"

namespace mpmvv::claims {

/// Two numbers with so many digits, or with as many more as it takes to tell them apart where they differ.
std::pair<std::string, std::string> told_apart(double a, double b, int digits);

/// What a criterion asks of a number: "1.75 to 2.25", "1", "at least 0.5"; empty without bounds.
std::string bounds_text(const records::ClaimPart& part);

/// A number in four digits, or in as many more as tell it from the bounds where it differs from them.
std::string told_from_bounds(const records::ClaimPart& part, double value);

/// "0.93 to 1.6", with as many digits as tell the ends apart; "without bounds"; empty for less than round-off.
std::string range_text(double lower, double upper);

/// Whether a number may lie elsewhere than where it was found, by more than round-off.
bool has_interval(const records::Found& found);

/// What stands behind a number that was found: " ± 0.21" of an order, " (0.93 to 1.6)" of what times or replicates
/// make, " or less" of a limit below all that was tried. Empty without an interval, and of a limit with a bracket,
/// which its name has.
std::string interval_text(const records::ClaimPart& part, const records::Found& found);

/// The same with the remark on the number: " ± 0.21 (finest segment 1.42)".
std::string interval_and_remark(const records::ClaimPart& part, const records::Found& found);

}  // namespace mpmvv::claims
