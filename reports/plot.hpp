#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/chart.hpp"
#include "reports/sheet.hpp"

namespace mpmvv::reports {

/// A chart as its files say it: NAME.gp makes pictures of NAME.dat, all in one folder.
struct Plot {
  std::string name;
  std::string script;
  std::string data;
  std::vector<std::string> endings{".svg", ".pdf"};  ///< of the pictures' files
};

/// For a report.
Plot plot_of(const Chart& chart);

/// One picture for a paper; for LaTeX a second file holds what is no text.
Plot plot_of(const Chart& chart, const Sheet& sheet);

/// Whether the chart's axes are long enough to be read on such a sheet.
bool has_room(const Chart& chart, const Sheet& sheet);

/// Draws the plots whose script or data differ from the folder's, or whose pictures are absent; how many these were.
/// Throws UsageError when gnuplot is missing, fails, exceeds the time limit or leaves a picture out.
int draw(const std::vector<Plot>& plots, const std::filesystem::path& folder,
         std::chrono::milliseconds limit = std::chrono::seconds(60));

}  // namespace mpmvv::reports
