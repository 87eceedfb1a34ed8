#pragma once
#include "reports/report.hpp"
#include "reports/table.hpp"

namespace mpmvv::reports {

/// What studies found of other codes, a group for each version of a code; empty without one.
Table code_table(const ReportInput& input);

}  // namespace mpmvv::reports
