#pragma once
#include <filesystem>
#include <vector>

#include "reports/chart.hpp"
#include "reports/sheet.hpp"

namespace mpmvv::reports {

/// The files of a figure for a paper: for LaTeX there is a second one, FILE-lines.pdf, with its lines.
std::vector<std::filesystem::path> picture_files(const std::filesystem::path& file, Format format);

/// Draws a figure for a paper into these files. Throws UsageError when gnuplot is missing or fails, or a file cannot be
/// written.
void draw_picture(const Chart& chart, const Sheet& sheet, const std::filesystem::path& file);

}  // namespace mpmvv::reports
