#pragma once
#include <string>
#include <vector>

#include "reports/chart.hpp"
#include "studies/claims/trend.hpp"
#include "studies/store/version.hpp"

namespace mpmvv::reports {

/// The trends of one study against the versions: a small figure of its orders, one of its finest errors and one of its
/// limits, where it has any.
std::vector<Chart> trend_charts(const std::string& study, const std::vector<claims::Trend>& trends,
                                const std::vector<store::Version>& versions);

}  // namespace mpmvv::reports
