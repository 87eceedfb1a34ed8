#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "reports/chart.hpp"
#include "reports/report.hpp"

namespace mpmvv::reports {

/// A figure of a page: an SVG file beside it.
struct Picture {
  std::string name;
  std::string folder;  ///< of its files
  std::string caption;
  std::vector<std::string> notes;
  std::string description;    ///< what it shows, for people who do not see it
  int width = 0, height = 0;  ///< as drawn; 0 where nothing could be read
  std::string points = {};    ///< what the report's script says of each point, JSON; may be empty
};

/// The charts that are drawn in a folder of the report.
std::vector<Picture> pictures_of(const std::vector<Chart>& charts, const std::filesystem::path& out_dir,
                                 const std::string& folder);

/// The same for the charts of a study, with what the script says of their points.
std::vector<Picture> pictures_of(const std::vector<Chart>& charts, const std::filesystem::path& out_dir,
                                 const std::string& folder, const records::StudyResult& study,
                                 const std::vector<SeriesCommand>& commands);

/// What a chart shows, in words: its axes, and where each curve begins and ends or, of a stability map, each limit.
std::string description_of(const Chart& chart);

/// Every point of a chart of this study, by series: where it stands in the picture, in pixels, its swept value, what
/// was measured, and the command that repeats it. JSON; empty where the chart has no such points.
std::string points_of(const Chart& chart, const std::string& svg, const records::StudyResult& study,
                      const std::vector<SeriesCommand>& commands);

}  // namespace mpmvv::reports
