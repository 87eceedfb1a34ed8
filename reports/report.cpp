#include "reports/report.hpp"

#include <fmt/format.h>

#include <map>

#include "reports/chart.hpp"
#include "reports/csv.hpp"
#include "reports/mutant_table.hpp"
#include "reports/page.hpp"
#include "reports/plot.hpp"
#include "reports/table.hpp"
#include "reports/text.hpp"
#include "reports/trend_page.hpp"
#include "studies/error.hpp"
#include "studies/file.hpp"

namespace mpmvv {

namespace fs = std::filesystem;

namespace {

/// Names become file names, each of one figure only.
void check_names(const std::vector<StudyResult>& studies, const std::vector<std::vector<Chart>>& charts) {
  std::map<std::string, std::string> owner;
  const auto check = [](const std::string& what, const std::string& name) {
    if (!is_file_stem(name))
      throw UsageError(
          fmt::format("{} '{}' cannot name a file (use letters, digits, '.', '_', '+' and '-')", what, name));
  };
  for (std::size_t i = 0; i < studies.size(); ++i) {
    check("study", studies[i].name);
    for (const auto& chart : charts[i]) {
      check(fmt::format("study '{}': figure", studies[i].name), chart.name);
      const auto [first, added] = owner.try_emplace(chart.name, studies[i].name);
      if (!added)
        throw UsageError(fmt::format("figure '{}' is in study '{}' and in study '{}' (figures need different names)",
                                     chart.name, first->second, studies[i].name));
    }
  }
}

std::vector<std::string> write_tables(const StudyResult& study, const fs::path& folder, ReportSummary& summary) {
  auto files = csv_tables(study);
  files[study.name + ".tex"] = latex_tables(study.name + ": " + study.title, tables_of(study));
  std::vector<std::string> names;
  for (const auto& [name, content] : files) {
    names.push_back(name);
    summary.tables_written += write_if_changed(folder / name, content) ? 1 : 0;
  }
  summary.tables += static_cast<int>(names.size());
  return names;
}

}  // namespace

ReportSummary write_report(const ReportInput& input, const fs::path& out_dir,
                           const std::function<void(const std::string&)>& progress) {
  const fs::path figures = out_dir / "figures", tables = out_dir / "tables";
  std::vector<std::vector<Chart>> charts;
  std::vector<Plot> plots;
  for (const auto& study : input.studies) {
    charts.push_back(charts_of(study));
    for (const auto& chart : charts.back()) plots.push_back(plot_of(chart));
  }
  check_names(input.studies, charts);
  make_folder(figures);
  make_folder(tables);

  ReportSummary summary;
  summary.figures = static_cast<int>(plots.size());
  summary.figures_drawn = draw(plots, figures);
  progress(fmt::format("figures: {} of {} redrawn", summary.figures_drawn, summary.figures));

  std::vector<Section> sections;
  for (std::size_t i = 0; i < input.studies.size(); ++i)
    sections.push_back({&input.studies[i], pictures_of(charts[i], out_dir, "figures"),
                        write_tables(input.studies[i], tables, summary)});
  if (input.benchmark) {
    const auto text = latex_tables("Benchmark", benchmark_tables(*input.benchmark));
    ++summary.tables;
    summary.tables_written += write_if_changed(tables / "benchmark.tex", text) ? 1 : 0;
  }
  if (!input.mutants.empty()) {
    const auto text = latex_tables("Planted mistakes", mutant_tables(input.mutants, input.alarms));
    ++summary.tables;
    summary.tables_written += write_if_changed(tables / "mutants.tex", text) ? 1 : 0;
  }
  progress(fmt::format("tables: {} of {} written", summary.tables_written, summary.tables));

  if (has_trends(input)) write_trends(input, out_dir, summary);
  write_if_changed(out_dir / "index.html", render_page(input, sections));
  progress(fmt::format("report: {}", (out_dir / "index.html").string()));
  return summary;
}

}  // namespace mpmvv
