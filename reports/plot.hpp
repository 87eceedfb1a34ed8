#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/chart.hpp"
#include "reports/sheet.hpp"

namespace mpmvv::reports {

/// A chart as files in one folder: NAME.gp makes pictures of NAME.dat.
struct Plot {
  std::string name;
  std::string script;
  std::string data;
  std::vector<std::string> endings{".svg", ".pdf"};  ///< of the pictures' files
};

/// The plot of a chart for a report.
Plot plot_of(const Chart& chart);

/// The plot of a chart for a paper: one picture in the sheet's format. For LaTeX a second file holds what is no text.
Plot plot_of(const Chart& chart, const Sheet& sheet);

/// Whether the chart's height follows from its scale or its named rows, whatever that of the sheet.
bool has_own_height(const Chart& chart);

/// Whether the chart's axes are long enough to be read on such a sheet.
bool has_room(const Chart& chart, const Sheet& sheet);

/// The height of the chart on the sheet, with its key, in mm.
double height_of(const Chart& chart, const Sheet& sheet);

/// The height of a letter on the sheet, about, as a fraction of the axes': `paper_letter` on a sheet as it is by
/// itself.
double letter_on(const Sheet& sheet);

/// Draws the plots whose script or data differ from the folder's, or whose pictures are absent; returns how many these
/// were. Throws UsageError when gnuplot is missing, fails, exceeds the time limit, which is that for ten plots, or
/// leaves a picture out.
int draw(const std::vector<Plot>& plots, const std::filesystem::path& folder,
         std::chrono::milliseconds limit = std::chrono::seconds(60));

}  // namespace mpmvv::reports
