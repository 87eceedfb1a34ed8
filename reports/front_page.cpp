#include <fmt/format.h>

#include <algorithm>

#include "page_template.hpp"
#include "reports/claim_cards.hpp"
#include "reports/criteria.hpp"
#include "reports/first_screen.hpp"
#include "reports/gate_data.hpp"
#include "reports/page_frame.hpp"
#include "reports/study_cards.hpp"

namespace mpmvv::reports {

using namespace template_data;
using records::Verdict;

namespace {

std::size_t points_in(const records::StudyResult& study) {
  std::size_t points = 0;
  for (const auto& series : study.series)
    points += series.points.size() + (series.limit ? series.limit->probes.size() : 0);
  return points;
}

/// By what the column of goldens is sorted: the worst verdict, then how many goldens have it.
std::string sort_key(const std::vector<GateLine>& lines) {
  const auto verdict = gate_verdict(lines);
  const auto count = verdict ? std::ranges::count(lines, *verdict, &GateLine::verdict) : 0;
  return fmt::format("{} {}", gate_word(lines), count);
}

data study_row(const ReportInput& input, const records::StudyResult& study) {
  std::vector<GateLine> lines;
  std::ranges::copy_if(input.gate, std::back_inserter(lines), [&](const GateLine& g) { return g.study == study.name; });
  const auto claim = [&](const std::string& id) { return object({{"id", id}}); };
  return object({{"study", study.name},
                 {"title", study.title},
                 {"kind", to_string(study.kind)},
                 {"points_count", fmt::format("{}", points_in(study))},
                 {"goldens", lines.empty() ? "none" : gate_counts(lines)},
                 {"goldens_key", sort_key(lines)},
                 {"verdict", gate_word(lines)},
                 {"claims", list_of(study.claims, claim)}});
}

data claim_entry(const claims::Claim& claim) {
  return object({{"id", claim.id},
                 {"claim_file", anchor(claim.id)},
                 {"statement", claim.statement},
                 {"verdict", to_string(claim.verdict)},
                 {"count", count_text(claim)}});
}

bool has_failing(const claims::Claim& claim) {
  const auto verdict = [](const claims::JudgedPart& line) { return line.part.verdict; };
  return std::ranges::find(claim.parts, records::PartVerdict::fails, verdict) != claim.parts.end();
}

/// Claims that are refuted or open, and those that hold in part; the latter are folded, as they are many.
data unsettled_claims(const std::vector<claims::Claim>& claims) {
  data lists{data::type::list};
  const auto add = [&](const char* heading, bool is_open, const auto& belongs) {
    std::vector<claims::Claim> own;
    std::ranges::copy_if(claims, std::back_inserter(own), belongs);
    if (!own.empty())
      lists << object({{"heading", heading},
                       {"number", fmt::format("{}", own.size())},
                       {"is_open", is_open},
                       {"claims", list_of(own, claim_entry)}});
  };
  using enum claims::Claim::Verdict;
  add("Claims refuted", true, [](const claims::Claim& c) { return c.verdict == refuted; });
  add("Claims open", true, [](const claims::Claim& c) { return c.verdict == open; });
  add("Claims that hold in part, the rest fails", false,
      [](const claims::Claim& c) { return c.verdict == partly && has_failing(c); });
  add("Claims that hold in part, the rest is undecided", false,
      [](const claims::Claim& c) { return c.verdict == partly && !has_failing(c); });
  return lists;
}

/// Whether a study is shown that comes with the program.
bool shows_shipped(const ReportInput& input) {
  return std::ranges::any_of(input.calls, [](const auto& call) { return call.second.study == call.first; });
}

data provenance_data(const Origin& origin) {
  const store::Provenance& p = origin.provenance;
  return object({{"studies", studies_text(origin.studies)},
                 {"digest", p.digest},
                 {"commit", p.commit},
                 {"dirty", p.dirty},
                 {"compiler", p.compiler},
                 {"flags", p.flags},
                 {"build_type", p.build_type},
                 {"cpu", p.cpu},
                 {"time", p.time}});
}

void add_changes(data& all, const std::string& heading, const Changes& changes) {
  std::vector<std::string> lines = changes.differ;
  for (const std::string& what : changes.gone) lines.push_back(what + ": no result");
  if (lines.empty()) return;
  const std::string gone = changes.gone.empty() ? "" : fmt::format(", {} without a result", changes.gone.size());
  all << object(
      {{"heading", fmt::format("{}: {} of {} results{}", heading, changes.differ.size(), changes.compared, gone)},
       {"lines", text_list(lines)}});
}

/// What changed since the version before, in the program and in other codes.
data all_changes(const ReportInput& input) {
  data all{data::type::list};
  if (input.earlier) add_changes(all, "What changed since " + input.earlier->label, input.earlier->changes);
  for (const auto& [code, versions, trends, newest] : input.histories)
    if (!code.empty())
      add_changes(all,
                  fmt::format("What changed in {} from {} to {}", code, store::label(*(versions.end() - 2)),
                              store::label(versions.back())),
                  newest);
  return all;
}

}  // namespace

Page front_page(const ReportInput& input, const std::vector<Section>& sections) {
  const GateSplit gate = gate_split(input);
  const auto row = [&](const records::StudyResult& study) { return study_row(input, study); };
  return framed_page("index.html", "mpmvv: " + gate_text(gate), front_template, input,
                     object({{"tiles", first_screen(input)},
                             {"groups", failing_goldens(gate.judged, input.studies)},
                             {"has_failing", gate_verdict(gate.judged).value_or(Verdict::pass) != Verdict::pass},
                             {"has_gate", !gate.judged.empty()},
                             {"missing", missing_goldens_text(gate.without_study)},
                             {"has_missing", !gate.without_study.empty()},
                             {"unsettled", unsettled_claims(input.claims)},
                             {"changes", all_changes(input)},
                             {"papers", claim_cards(input.claims, sections)},
                             {"has_papers", !input.claims.empty()},
                             {"studies", list_of(input.studies, row)},
                             {"study_cards", study_cards(sections)},
                             {"has_shipped", shows_shipped(input)},
                             {"origins", list_of(origins_of(input.provenances), provenance_data)},
                             {"written", input.written}}));
}

}  // namespace mpmvv::reports
