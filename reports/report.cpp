#include "reports/report.hpp"

#include <fmt/format.h>

#include "reports/chart.hpp"
#include "reports/code_table.hpp"
#include "reports/convergence_table.hpp"
#include "reports/csv.hpp"
#include "reports/latex_table.hpp"
#include "reports/mutant_table.hpp"
#include "reports/orders_table.hpp"
#include "reports/page.hpp"
#include "reports/report_files.hpp"
#include "reports/report_place.hpp"
#include "reports/table.hpp"
#include "reports/text.hpp"
#include "reports/trend_page.hpp"

namespace mpmvv::reports {

using records::StudyResult;

namespace fs = std::filesystem;

namespace {

void write_table(const fs::path& folder, const std::string& name, const std::string& text, ReportSummary& summary) {
  ++summary.tables;
  summary.tables_written += write_file(folder, fs::path("tables") / name, text, summary) ? 1 : 0;
}

/// The tables of a study for a paper. All of its points and fits are in the CSV files.
std::string latex_of(const StudyResult& study) {
  std::vector<Table> others{limits_table(study), replicates_table(study), values_table(study), cheapest_table(study)};
  std::erase_if(others, &Table::empty);
  return latex_head(study.name + ": " + study.title) + latex_convergence_tables(study) +
         latex_long_table(orders_table({&study})) + latex_long_table(extrapolated_table({&study})) +
         latex_tables(others);
}

std::vector<std::string> write_tables(const StudyResult& study, const fs::path& folder, ReportSummary& summary) {
  auto files = csv_tables(study);
  files[study.name + ".tex"] = latex_of(study);
  std::vector<std::string> names;
  for (const auto& [name, content] : files) {
    names.push_back(name);
    write_table(folder, name, content, summary);
  }
  return names;
}

std::vector<SeriesCommand> commands_of(const ReportInput& input, std::size_t study) {
  const auto found = input.commands.find(input.studies[study].name);
  return found == input.commands.end() ? std::vector<SeriesCommand>{} : found->second;
}

void write_pages(const ReportInput& input, const std::vector<Section>& sections, const fs::path& folder,
                 ReportSummary& summary) {
  const auto write_page = [&](const Page& page) { write_file(folder, page.file, page.text, summary); };
  for (const Page& aid : page_aids()) write_page(aid);
  for (const Section& section : sections) {
    write_page(study_page(input, section));
    for (const Page& points : points_pages(section)) write_page(points);
  }
  for (const claims::Claim& claim : input.claims) write_page(claim_page(input, claim, sections));
  for (const Page& page : program_pages(input)) write_page(page);
  write_page(gate_page(input));
  write_page(front_page(input, sections));
}

}  // namespace

ReportSummary write_report(const ReportInput& input, const fs::path& out_dir,
                           const std::function<void(const std::string&)>& progress) {
  const auto charts = charts_of_all(input.studies);
  std::vector<Plot> plots;
  for (const auto& of_study : charts)
    for (const auto& chart : of_study) plots.push_back(plot_of(chart));
  const ReportPlace place(out_dir, progress);
  ReportSummary summary;
  draw_files(place.draft(), "figures", plots, summary);
  progress(fmt::format("figures: {} of {} redrawn", summary.figures_drawn, summary.figures));

  std::vector<Section> sections;
  for (std::size_t i = 0; i < input.studies.size(); ++i)
    sections.push_back({&input.studies[i],
                        pictures_of(charts[i], place.draft(), "figures", input.studies[i], commands_of(input, i)),
                        write_tables(input.studies[i], place.draft(), summary)});
  if (input.benchmark)
    write_table(place.draft(), "program/benchmark.tex",
                latex_head("Benchmark") + latex_tables(benchmark_tables(*input.benchmark)), summary);
  if (!input.codes.empty())
    write_table(place.draft(), "program/codes.tex", latex_head("Other codes") + latex_tables({code_table(input)}),
                summary);
  if (input.mutation)
    write_table(place.draft(), "program/mutants.tex",
                latex_head("Planted mistakes") + latex_tables(mutant_tables(*input.mutation, input.alarms)), summary);
  progress(fmt::format("tables: {} of {} written", summary.tables_written, summary.tables));

  if (!input.histories.empty()) write_trends(input, place.draft(), summary);
  write_pages(input, sections, place.draft(), summary);
  place.take_place(summary.files);
  progress(fmt::format("report: {}", (out_dir / "index.html").string()));
  return summary;
}

}  // namespace mpmvv::reports
