#pragma once
#include "reports/report.hpp"
#include "reports/template_data.hpp"

namespace mpmvv::reports {

/// Four numbers that say how it stands, each with what changed since the version before: gate, claims, cost, age.
template_data::data first_screen(const ReportInput& input);

}  // namespace mpmvv::reports
