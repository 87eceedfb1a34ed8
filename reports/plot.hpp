#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/chart.hpp"

namespace mpmvv::reports {

/// A chart as its files say it: NAME.gp makes NAME.svg and NAME.pdf of NAME.dat, all in one folder.
struct Plot {
  std::string name;
  std::string script;
  std::string data;
};

Plot plot_of(const Chart& chart);

/// Draws the plots whose script or data differ from the folder's, or whose pictures are absent; how many these were.
/// Throws UsageError when gnuplot is missing, fails, exceeds the time limit or leaves a picture out.
int draw(const std::vector<Plot>& plots, const std::filesystem::path& folder,
         std::chrono::milliseconds limit = std::chrono::seconds(60));

}  // namespace mpmvv::reports
