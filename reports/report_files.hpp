#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "reports/plot.hpp"
#include "reports/report.hpp"

/// What a report writes, which its summary lists.
namespace mpmvv::reports {

/// Writes a file of the report in `folder`, unless it has this text already; returns whether it was written.
bool write_file(const std::filesystem::path& folder, const std::filesystem::path& file, const std::string& text,
                ReportSummary& summary);

/// Draws the plots that have changed into `place`, a folder in the report's `folder`.
void draw_files(const std::filesystem::path& folder, const std::string& place, const std::vector<Plot>& plots,
                ReportSummary& summary);

}  // namespace mpmvv::reports
