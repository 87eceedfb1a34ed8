#include "reports/code_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/text.hpp"
#include "studies/claims/samples.hpp"

namespace mpmvv::reports {

namespace {

using records::ClaimPart;
using records::StudyResult;

std::string title_of(const store::CodeSeries& series) {
  return series.code.name + " " + series.code.version;
}

/// Whether the criterion looked at the series: the first name in quotes is that of which a number was found.
bool is_about(const ClaimPart& part, const std::string& series) {
  return std::ranges::any_of(part.found, [&](const records::Found& found) {
    const std::size_t quote = found.what.find('\'');
    return quote != std::string::npos && found.what.substr(quote).starts_with("'" + series + "'");
  });
}

std::string order_and_window(const records::Series& series, const fits::ObservedOrder& o) {
  const std::string without = claims::left_out(series, o.norm);
  return fmt::format("{} in {}, {}{}", order_text(o), o.norm, window_text(o.from, o.to),
                     without.empty() ? "" : " without " + without);
}

std::string limit_and_bracket(const fits::StabilityLimit& limit) {
  if (!limit.found) return fmt::format("no limit in {}: {}", limit.key, text_without_limit(limit));
  return fmt::format("stable at {}, unstable at {} in {}{}", brief(limit.stable), brief(limit.unstable), limit.key,
                     limit.monotone ? "" : ", not monotone");
}

/// The orders and the limit that were found.
std::string fitted_of(const records::Series& series) {
  std::vector<std::string> fitted;
  for (const fits::ObservedOrder& order : series.orders) fitted.push_back(order_and_window(series, order));
  if (series.limit) fitted.push_back(limit_and_bracket(*series.limit));
  return fitted.empty() ? "–" : fmt::format("{}", fmt::join(fitted, "; "));
}

/// What was asked of the series, and whether it holds.
std::string asked_of(const StudyResult& study, const std::string& series) {
  std::vector<std::string> asked;
  for (const ClaimPart& part : study.parts)
    if (is_about(part, series)) asked.push_back(fmt::format("{}: {}", part.statement, to_string(part.verdict)));
  return asked.empty() ? "–" : fmt::format("{}", fmt::join(asked, "; "));
}

/// The claims that these criteria belong to, as their study states them.
std::string findings_of(const ReportInput& input, const StudyResult& study, const std::string& series) {
  std::vector<std::string> findings;
  for (const claims::Claim& claim : input.claims)
    if (std::ranges::any_of(study.parts,
                            [&](const ClaimPart& part) { return part.claim == claim.id && is_about(part, series); }))
      findings.push_back(fmt::format("{} ({})", claim.statement, to_string(claim.verdict)));
  return findings.empty() ? "–" : fmt::format("{}", fmt::join(findings, "; "));
}

}  // namespace

Table code_table(const ReportInput& input) {
  Table table{
      "Other codes: what was found, as it was found. A version is what its program says, or the digest of its file",
      {"study", "series", "variant", "body force", "date", "order or limit", "asked", "finding"},
      {}};
  std::vector<store::CodeSeries> all = input.codes;
  std::ranges::stable_sort(all, {}, title_of);
  for (const store::CodeSeries& s : all) {
    const auto study = std::ranges::find(input.studies, s.study, &StudyResult::name);
    if (study == input.studies.end()) continue;
    const auto series = std::ranges::find(study->series, s.series, &records::Series::name);
    if (series == study->series.end()) continue;
    const std::string title = title_of(s);
    if (table.groups.empty() || table.groups.back().title != title) table.groups.push_back({title, {}});
    table.groups.back().rows.push_back({s.study, s.series, s.code.variant.empty() ? "–" : s.code.variant,
                                        s.code.force_form, s.kept_at.substr(0, 10), fitted_of(*series),
                                        asked_of(*study, s.series), findings_of(input, *study, s.series)});
  }
  return table;
}

}  // namespace mpmvv::reports
