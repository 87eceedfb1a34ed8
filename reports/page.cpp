#include "reports/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>

#include "page_template.hpp"
#include "reports/mutant_table.hpp"
#include "reports/table.hpp"
#include "reports/template_data.hpp"
#include "reports/text.hpp"
#include "studies/support/file.hpp"

namespace mpmvv::reports {

namespace {

using namespace template_data;

/// "2 pass, 1 fail": the words in this order, unknown ones after them.
std::string counts(const std::vector<std::string>& words, std::initializer_list<std::string> order) {
  std::map<std::string, int> count;
  for (const auto& w : words) ++count[w];
  std::string text;
  const auto add = [&](const std::string& w) {
    if (const int n = count.contains(w) ? count.at(w) : 0; n > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, w);
    count.erase(w);
  };
  for (const auto& w : order) add(w);
  while (!count.empty()) add(std::string(count.begin()->first));
  return text.empty() ? "none" : text;
}

template <typename Lines>
std::vector<std::string> verdicts(const Lines& lines) {
  std::vector<std::string> words;
  for (const auto& line : lines) words.push_back(line.verdict);
  return words;
}

std::string overall(const std::vector<std::string>& gate) {
  const auto has = [&](const char* word) { return std::ranges::find(gate, word) != gate.end(); };
  return gate.empty() ? "not judged" : has("fail") ? "fail" : has("inconclusive") ? "inconclusive" : "pass";
}

/// What all cells of a column are: numbers stand on the right, short texts in one line.
struct ColumnKind {
  bool number = true, word = true;
};

ColumnKind kind_of_column(const Table& table, std::size_t column) {
  constexpr std::size_t longest_word = 18;
  ColumnKind kind;
  for (const auto& group : table.groups)
    for (const auto& row : group.rows) {
      kind.number = kind.number && is_number(row[column]);
      kind.word = kind.word && row[column].size() <= longest_word;
    }
  return kind;
}

data table_data(const Table& table) {
  std::vector<ColumnKind> kinds;
  for (std::size_t c = 0; c < table.columns.size(); ++c) kinds.push_back(kind_of_column(table, c));
  const auto cells = [&](const std::vector<std::string>& texts) {
    data list{data::type::list};
    for (std::size_t c = 0; c < texts.size(); ++c)
      list << object({{"text", texts[c]}, {"number", kinds[c].number}, {"word", kinds[c].word && !kinds[c].number}});
    return list;
  };
  const auto row = [&](const std::vector<std::string>& texts) { return object({{"cells", cells(texts)}}); };
  const auto group = [&](const Table::Group& g) {
    return object({{"group_title", g.title}, {"titled", !g.title.empty()}, {"rows", list_of(g.rows, row)}});
  };
  return object({{"table_caption", table.caption},
                 {"columns", cells(table.columns)},
                 {"width", fmt::format("{}", table.columns.size())},
                 {"groups", list_of(table.groups, group)}});
}

data part_data(const records::ClaimPart& part) {
  return object({{"claim", part.claim},
                 {"claim_anchor", anchor(part.claim)},
                 {"statement", part.statement},
                 {"verdict", to_string(part.verdict)},
                 {"evidence", part.evidence},
                 {"reason", part.reason}});
}

data claim_link(const std::string& id) {
  return object({{"id", id}, {"claim_anchor", anchor(id)}});
}

data section_data(const Section& section) {
  const auto& study = *section.study;
  return object({{"study", study.name},
                 {"study_anchor", anchor(study.name)},
                 {"title", study.title},
                 {"kind", study.kind},
                 {"study_claims", list_of(study.claims, claim_link)},
                 {"parts", list_of(study.parts, part_data)},
                 {"has_parts", !study.parts.empty()},
                 {"pictures", list_of(section.pictures, picture_data)},
                 {"tables", list_of(tables_of(study), table_data)},
                 {"table_files", text_list(section.tables)},
                 {"study_file", study.text}});
}

data benchmark_data(const Benchmark& benchmark) {
  return object({{"tables", list_of(benchmark_tables(benchmark), table_data)}});
}

data mutants_data(const ReportInput& input) {
  return object({{"tables", list_of(mutant_tables(*input.mutation, input.alarms), table_data)},
                 {"is_summary", input.mutation->mistakes.empty()},
                 {"is_of_another_build", input.mutation->digest != input.provenance.digest},
                 {"commit", input.mutation->commit}});
}

data gate_data(const GateLine& g) {
  return object({{"name", g.name},
                 {"verdict", g.verdict},
                 {"expected", g.expected},
                 {"measured", g.measured},
                 {"reason", g.reason}});
}

data claim_data(const ClaimLine& claim, const std::vector<Section>& sections) {
  data studies{data::type::list};
  for (const auto& s : sections)
    if (std::ranges::find(s.study->claims, claim.id) != s.study->claims.end())
      studies << object({{"study", s.study->name}, {"study_anchor", anchor(s.study->name)}});
  return object({{"id", claim.id},
                 {"claim_anchor", anchor(claim.id)},
                 {"verdict", claim.verdict},
                 {"evidence", claim.evidence},
                 {"claim_studies", studies}});
}

data provenance_data(const store::Provenance& p) {
  return object({{"digest", p.digest},
                 {"commit", p.commit},
                 {"dirty", p.dirty},
                 {"compiler", p.compiler},
                 {"flags", p.flags},
                 {"build_type", p.build_type},
                 {"cpu", p.cpu},
                 {"time", p.time}});
}

}  // namespace

std::vector<Picture> pictures_of(const std::vector<Chart>& charts, const std::filesystem::path& out_dir,
                                 const std::string& folder) {
  std::vector<Picture> pictures;
  for (const auto& c : charts)
    pictures.push_back(
        {c.name, folder, c.caption, c.notes, support::read_file(out_dir / folder / (c.name + ".svg")).value_or("")});
  return pictures;
}

std::string render_page(const ReportInput& input, const std::vector<Section>& sections) {
  kainjow::mustache::mustache page{std::string(page_template)};
  const auto gate = verdicts(input.gate);
  const std::vector<Benchmark> benchmark_list(input.benchmark ? 1 : 0, input.benchmark.value_or(Benchmark{}));
  const std::vector<ReportInput> with_mutants(input.mutation ? 1 : 0, input);
  return marked_up_text(page.render(
      object({{"overall", overall(gate)},
              {"gate_counts", counts(gate, {"pass", "fail", "inconclusive"})},
              {"claim_counts", counts(verdicts(input.claims), {"confirmed", "refuted", "partly", "shown", "open"})},
              {"provenance", provenance_data(input.provenance)},
              {"gate", list_of(input.gate, gate_data)},
              {"has_gate", !input.gate.empty()},
              {"claims", list_of(input.claims, [&](const ClaimLine& c) { return claim_data(c, sections); })},
              {"has_claims", !input.claims.empty()},
              {"benchmark", list_of(benchmark_list, benchmark_data)},
              {"mutants", list_of(with_mutants, mutants_data)},
              {"table_list", partial(tables_template)},
              {"picture_list", partial(pictures_template)},
              {"style", partial(style_template)},
              {"has_trends", has_trends(input)},
              {"sections", list_of(sections, section_data)}})));
}

}  // namespace mpmvv::reports
