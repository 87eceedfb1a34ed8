#pragma once
#include <string>
#include <vector>

#include "reports/chart.hpp"
#include "reports/report.hpp"

namespace mpmvv::reports {

/// The trends of one study against the versions of our own program or of another code: a small figure of its orders,
/// one of its finest errors in each quantity, and one of its limits in each key, where it has any.
std::vector<Chart> trend_charts(const std::string& study, const History& history);

}  // namespace mpmvv::reports
