#pragma once
#include <string>
#include <vector>

#include "reports/report.hpp"
#include "reports/template_data.hpp"

namespace mpmvv::reports {

/// "1.75 to 2.25", "at least 0.8", "at most 3", "4" for a bound on both sides, each with all its digits; empty where
/// nothing is asked.
std::string asked_text(const records::ClaimPart& part);

/// A number that was found, with four digits, or with as many as tell it from the bounds.
std::string told_from_bounds(const records::ClaimPart& part, double value);

/// Why a criterion is inconclusive.
std::string undecided_text(const records::ClaimPart& part);

/// The number on which a claim's verdict hangs, "order of 'linear': 0.43 ± 0.02 (asked: at most 0.5)": of the criteria
/// that decide it, the one that lies farthest beyond its bound or, where none fails, nearest to it (one on its
/// bound only where there is no other); where an interval leaves one open, by the interval. Where several studies judge
/// the claim, that of the number stands behind it. A check's value does not name what it is of: its criterion's
/// statement stands before it. Where the verdict hangs on no number it is the statement of the first criterion that
/// does not hold.
std::string deciding_text(const claims::Claim& claim);

/// "7 of 8 criteria hold", "shown in figures", "not judged yet".
std::string count_text(const claims::Claim& claim);

/// Criteria for their template; each names its study.
template_data::data criteria_data(const std::vector<claims::JudgedPart>& parts);

}  // namespace mpmvv::reports
