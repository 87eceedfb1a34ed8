#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "reports/chart.hpp"
#include "reports/report.hpp"

namespace mpmvv::reports {

/// A figure on the page.
struct Picture {
  std::string name;
  std::string folder;  ///< of its files, beside the page
  std::string caption;
  std::vector<std::string> notes;
  std::string svg;  ///< the file's content
};

/// One study's part of the page.
struct Section {
  const records::StudyResult* study = nullptr;
  std::vector<Picture> pictures;
  std::vector<std::string> tables;  ///< names of its files in tables/
};

/// The charts that are drawn in a folder of the report.
std::vector<Picture> pictures_of(const std::vector<Chart>& charts, const std::filesystem::path& out_dir,
                                 const std::string& folder);

/// The whole page, from the template page.mustache. Every text is escaped.
std::string render_page(const ReportInput& input, const std::vector<Section>& sections);

}  // namespace mpmvv::reports
