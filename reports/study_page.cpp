#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "page_template.hpp"
#include "reports/gate_data.hpp"
#include "reports/page_frame.hpp"
#include "reports/table_data.hpp"
#include "reports/text.hpp"

namespace mpmvv::reports {

using namespace template_data;
using records::StudyResult;

namespace {

bool has_page(const ReportInput& input, const std::string& claim) {
  return std::ranges::find(input.claims, claim, &claims::Claim::id) != input.claims.end();
}

data claim_links(const ReportInput& input, const StudyResult& study) {
  return list_of(study.claims, [&](const std::string& id) {
    return object({{"id", id}, {"claim_file", anchor(id)}, {"has_page", has_page(input, id)}});
  });
}

/// The study's criteria, without their numbers, which stand on the claims' pages.
data criteria_list(const ReportInput& input, const StudyResult& study) {
  return list_of(study.parts, [&](const records::ClaimPart& part) {
    return object({{"statement", part.statement},
                   {"verdict", to_string(part.verdict)},
                   {"claim", part.claim},
                   {"claim_file", anchor(part.claim)},
                   {"has_page", has_page(input, part.claim)}});
  });
}

/// "strata 2.4", the code that ran the series; empty for our own solver.
std::string code_of(const records::Series& series) {
  return series.code ? fmt::format("{} {}", series.code->name, store::in_short(series.code->version)) : "";
}

/// Each code beside our own solver, and the series that it ran.
data code_list(const StudyResult& study) {
  std::map<std::string, std::vector<std::string>> codes;
  for (const records::Series& series : study.series)
    if (series.code) codes[code_of(series)].push_back(series.name);
  data list{data::type::list};
  for (const auto& [code, series] : codes)
    list << object({{"code", code}, {"series", fmt::format("{}", fmt::join(series, "; "))}});
  return list;
}

/// The value at which the page repeats a series: the last swept one, or the stable end of the limit's bracket, else the
/// unstable one, else the first one tried. NaN where there is none.
double repeated_value(const records::Series& series, bool is_probe) {
  if (!is_probe) return series.points.empty() ? support::not_measured : series.points.back().x;
  if (!series.limit || series.limit->probes.empty()) return support::not_measured;
  for (const double end : {series.limit->stable, series.limit->unstable})
    if (!std::isnan(end)) return end;
  return series.limit->probes.front().value;
}

/// The commands of each series that has a value to repeat.
data command_list(const ReportInput& input, const StudyResult& study) {
  data list{data::type::list};
  const auto of_study = input.commands.find(study.name);
  if (of_study == input.commands.end()) return list;
  for (const SeriesCommand& c : of_study->second) {
    const auto series = std::ranges::find(study.series, c.series, &records::Series::name);
    const double value = series == study.series.end() ? support::not_measured : repeated_value(*series, c.is_probe);
    if (std::isnan(value)) continue;
    const std::string code = code_of(*series), note = code + (code.empty() || c.note.empty() ? "" : ", ") + c.note;
    list << object({{"series", c.series},
                    {"text", replace_all(c.text, "{}", fmt::format("{}", value))},
                    {"note", note},
                    {"has_note", !note.empty()}});
  }
  return list;
}

std::vector<GateLine> goldens_of(const ReportInput& input, const StudyResult& study) {
  std::vector<GateLine> lines;
  std::ranges::copy_if(input.gate, std::back_inserter(lines), [&](const GateLine& g) { return g.study == study.name; });
  return lines;
}

std::vector<Table> tables_of_page(const ReportInput& input, const StudyResult& study) {
  const auto dimension = input.dimensions.find(study.name);
  return tables_of(study, dimension == input.dimensions.end() ? 0 : dimension->second);
}

/// The tables of what was fitted, or the one of all points.
data table_part(std::vector<Table> tables, bool is_fitted) {
  std::erase_if(tables, [&](const Table& table) { return (table.caption != points_caption) != is_fitted; });
  return object({{"tables", list_of(tables, table_data)}});
}

}  // namespace

Page study_page(const ReportInput& input, const Section& section) {
  const StudyResult& study = *section.study;
  const auto goldens = goldens_of(input, study);
  const data commands = command_list(input, study);
  const std::vector<Table> tables = tables_of_page(input, study);
  return framed_page("studies/" + study.name + ".html", study.name + ": " + study.title, study_template, input,
                     object({{"study", study.name},
                             {"title", study.title},
                             {"kind", to_string(study.kind)},
                             {"study_claims", claim_links(input, study)},
                             {"has_claims", !study.claims.empty()},
                             {"codes", code_list(study)},
                             {"parts", criteria_list(input, study)},
                             {"has_parts", !study.parts.empty()},
                             {"pictures", list_of(section.pictures, picture_data)},
                             {"fitted", table_part(tables, true)},
                             {"measured", table_part(tables, false)},
                             {"table_files", text_list(section.tables)},
                             {"goldens", gate_counts(goldens)},
                             {"has_goldens", !goldens.empty()},
                             {"study_anchor", anchor(study.name)},
                             {"groups", failing_goldens(goldens, input.studies)},
                             {"commands", commands},
                             {"has_commands", commands.is_non_empty_list()},
                             {"command", command_of(input, {study.name})},
                             {"study_file", study.text}}));
}

}  // namespace mpmvv::reports
