#pragma once
#include <vector>

#include "reports/table.hpp"

namespace mpmvv::reports {

/// The fitted orders of these studies, a group for each that has any.
Table orders_table(const std::vector<const records::StudyResult*>& studies);

/// The extrapolated values of these studies, a group for each that has any.
Table extrapolated_table(const std::vector<const records::StudyResult*>& studies);

}  // namespace mpmvv::reports
