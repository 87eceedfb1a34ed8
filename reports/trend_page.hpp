#pragma once
#include <filesystem>

#include "reports/report.hpp"

namespace mpmvv::reports {

/// Writes OUT/trend.html and the figures in OUT/trends/; adds these to the summary.
void write_trends(const ReportInput& input, const std::filesystem::path& out_dir, ReportSummary& summary);

}  // namespace mpmvv::reports
