#include "reports/trend_page.hpp"

#include <fmt/format.h>

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
constexpr std::size_t versions_at_first = 10;  ///< in the table above the figures; the earlier ones open with a click

data version_data(const store::Version& version, std::size_t number) {
  return template_data::object({{"number", std::to_string(number)},
                                {"time", version.time},
                                {"day", version.time.substr(0, version.time.find('T'))},
                                {"commits", template_data::list_of(version.commits, store::in_short)},
                                {"digest", store::in_short(version.digest)}});
}

using Charts = std::map<std::string, std::vector<Chart>>;  ///< by study

Charts charts_of(const History& history) {
  Charts charts;
  for (const claims::Trend& trend : history.trends) charts[trend.study];
  for (auto& [study, of_study] : charts) of_study = trend_charts(study, history);
  std::erase_if(charts, [](const auto& of_study) { return of_study.second.empty(); });
  return charts;
}

/// The versions from number `last` down to `first`, counted from 1.
data version_table(const History& history, std::size_t first, std::size_t last, bool is_earlier) {
  data versions{data::type::list};
  for (std::size_t number = last; number >= first; --number)
    versions << version_data(history.versions[number - 1], number);
  const std::string code = history.code.empty() ? "mpmvv" : history.code;
  return template_data::object(
      {{"caption", (is_earlier ? "Earlier versions of " : "Versions of ") + code},
       {"is_earlier", is_earlier},
       {"count", fmt::format("{} earlier version{}", last + 1 - first, last == first ? "" : "s")},
       {"versions", versions}});
}

/// The newest first.
data version_tables(const History& history) {
  const std::size_t all = history.versions.size(), earlier = all - std::min(all, versions_at_first);
  data tables{data::type::list};
  tables << version_table(history, earlier + 1, all, false);
  if (earlier > 0) tables << version_table(history, 1, earlier, true);
  return tables;
}

data history_data(const History& history, const Charts& charts, const std::filesystem::path& out_dir) {
  data sections{data::type::list};
  for (const auto& [study, of_study] : charts)
    sections << template_data::object(
        {{"study", study},
         {"anchor",
          (history.code.empty() ? "" : template_data::anchor(history.code) + "~") + template_data::anchor(study)},
         {"pictures",
          template_data::list_of(pictures_of(of_study, out_dir, trends_folder), template_data::picture_data)}});
  return template_data::object({{"code", history.code.empty() ? "mpmvv" : history.code},
                                {"time_of", history.code.empty() ? "first result" : "last study"},
                                {"names", history.code.empty() ? "commits" : "says of itself"},
                                {"version_tables", version_tables(history)},
                                {"sections", sections}});
}

}  // namespace

void write_trends(const ReportInput& input, const std::filesystem::path& out_dir, ReportSummary& summary) {
  std::vector<Charts> charts;
  std::vector<Plot> plots;
  for (const History& history : input.histories)
    for (const auto& [study, of_study] : charts.emplace_back(charts_of(history)))
      for (const Chart& chart : of_study) plots.push_back(plot_of(chart));
  draw_files(out_dir, trends_folder, plots, summary);

  data histories{data::type::list};
  for (std::size_t h = 0; h < charts.size(); ++h) histories << history_data(input.histories[h], charts[h], out_dir);
  const Page page =
      framed_page("trend.html", "Trends", trend_template, input, template_data::object({{"histories", histories}}));
  write_file(out_dir, page.file, page.text, summary);
}

}  // namespace mpmvv::reports
