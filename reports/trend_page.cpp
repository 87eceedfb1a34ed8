#include "reports/trend_page.hpp"

#include <algorithm>
#include <map>

#include "page_template.hpp"
#include "reports/page_frame.hpp"
#include "reports/report_files.hpp"
#include "reports/trend_chart.hpp"

namespace mpmvv::reports {

namespace {

using template_data::data;

constexpr const char* trends_folder = "trends";

/// The first letters of a hash, which tell it from others, and whether the tree was dirty.
std::string in_short(const std::string& hash) {
  constexpr std::size_t letters = 12;
  const std::size_t end = std::min(hash.find('-'), hash.size());
  return hash.substr(0, std::min(letters, end)) + hash.substr(end);
}

data version_data(const store::Version& version, std::size_t number) {
  return template_data::object({{"number", std::to_string(number)},
                                {"time", version.time},
                                {"commits", template_data::list_of(version.commits, in_short)},
                                {"digest", in_short(version.digest)}});
}

data trend_section_data(const std::string& study, const std::vector<Picture>& pictures) {
  return template_data::object({{"study", study},
                                {"study_anchor", template_data::anchor(study)},
                                {"pictures", template_data::list_of(pictures, template_data::picture_data)}});
}

std::map<std::string, std::vector<Chart>> charts_by_study(const ReportInput& input) {
  std::map<std::string, std::vector<claims::Trend>> trends;
  for (const claims::Trend& trend : input.trends) trends[trend.study].push_back(trend);
  std::map<std::string, std::vector<Chart>> charts;
  for (const auto& [study, of_study] : trends)
    if (auto drawn = trend_charts(study, of_study, input.versions); !drawn.empty()) charts[study] = std::move(drawn);
  return charts;
}

}  // namespace

void write_trends(const ReportInput& input, const std::filesystem::path& out_dir, ReportSummary& summary) {
  const auto charts = charts_by_study(input);
  std::vector<Plot> plots;
  for (const auto& [study, of_study] : charts)
    for (const Chart& chart : of_study) plots.push_back(plot_of(chart));
  draw_files(out_dir, trends_folder, plots, summary);

  data versions{data::type::list}, sections{data::type::list};
  for (std::size_t v = 0; v < input.versions.size(); ++v) versions << version_data(input.versions[v], v + 1);
  for (const auto& [study, of_study] : charts)
    sections << trend_section_data(study, pictures_of(of_study, out_dir, trends_folder));
  const Page page = framed_page("trend.html", "Trends", trend_template, input,
                                template_data::object({{"versions", versions}, {"sections", sections}}));
  write_file(out_dir, page.file, page.text, summary);
}

}  // namespace mpmvv::reports
