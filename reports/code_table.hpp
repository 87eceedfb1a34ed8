#pragma once
#include "reports/report.hpp"
#include "reports/table.hpp"

namespace mpmvv::reports {

/// What the input's studies found of other codes, a group for each version of a code; empty without one. A series of
/// another code that none of these studies has is left out.
Table code_table(const ReportInput& input);

}  // namespace mpmvv::reports
