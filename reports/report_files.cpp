#include "reports/report_files.hpp"

#include "studies/support/file.hpp"

namespace mpmvv::reports {

namespace fs = std::filesystem;

bool write_file(const fs::path& folder, const fs::path& file, const std::string& text, ReportSummary& summary) {
  summary.files.insert(file);
  support::make_folder((folder / file).parent_path());
  return support::write_if_changed(folder / file, text);
}

void draw_files(const fs::path& folder, const std::string& place, const std::vector<Plot>& plots,
                ReportSummary& summary) {
  support::make_folder(folder / place);
  summary.figures += static_cast<int>(plots.size());
  summary.figures_drawn += draw(plots, folder / place);
  for (const Plot& plot : plots) {
    for (const char* source : {".gp", ".dat"}) summary.files.insert(fs::path(place) / (plot.name + source));
    for (const std::string& ending : plot.endings) summary.files.insert(fs::path(place) / (plot.name + ending));
  }
}

}  // namespace mpmvv::reports
