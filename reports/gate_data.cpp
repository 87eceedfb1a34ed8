#include "reports/gate_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace mpmvv::reports {

using namespace template_data;
using records::Verdict;

namespace {

/// What the value of a check means that a golden is of; empty for other goldens.
std::string meaning_of(const GateLine& golden, const std::vector<records::StudyResult>& studies) {
  const auto study = std::ranges::find(studies, golden.study, &records::StudyResult::name);
  if (study == studies.end()) return "";
  for (const records::Value& value : study->values)
    if (golden.name == fmt::format("value '{}'", value.name)) return value.meaning;
  return "";
}

}  // namespace

data gate_group_data(const GateGroup& group, const std::vector<records::StudyResult>& studies) {
  const auto line = [&](const GateLine& g) {
    const std::string meaning = meaning_of(g, studies);
    return object({{"name", g.name},
                   {"meaning", meaning},
                   {"has_meaning", !meaning.empty()},
                   {"verdict", to_string(g.verdict)},
                   {"expected", g.expected},
                   {"measured", g.measured},
                   {"reason", g.reason}});
  };
  return object({{"study", group.study},
                 {"study_anchor", anchor(group.study)},
                 {"verdict", gate_word(group.lines)},
                 {"counts", gate_counts(group.lines)},
                 {"is_open", gate_verdict(group.lines) != Verdict::pass},
                 {"has_reasons", std::ranges::any_of(group.lines, [](const GateLine& g) { return !g.reason.empty(); })},
                 {"lines", list_of(group.lines, line)}});
}

data failing_goldens(const std::vector<GateLine>& judged, const std::vector<records::StudyResult>& studies) {
  std::vector<GateLine> lines;
  std::ranges::copy_if(judged, std::back_inserter(lines), [](const GateLine& g) { return g.verdict != Verdict::pass; });
  return list_of(gate_groups(lines), [&](const GateGroup& group) { return gate_group_data(group, studies); });
}

std::string missing_goldens_text(const std::vector<GateLine>& lines) {
  constexpr std::size_t most_named = 12;
  std::vector<std::string> studies;
  for (const GateGroup& group : gate_groups(lines)) studies.push_back(group.study);
  if (studies.empty()) return "";
  const std::size_t named = std::min(most_named, studies.size());
  return fmt::format("{} of {} this report has no result of: {}{}.",
                     lines.size() == 1 ? "1 golden is" : fmt::format("{} goldens are", lines.size()),
                     studies.size() == 1 ? "a study that" : fmt::format("{} studies that", studies.size()),
                     fmt::join(studies.begin(), studies.begin() + static_cast<std::ptrdiff_t>(named), ", "),
                     studies.size() > named ? fmt::format(" and {} more", studies.size() - named) : "");
}

}  // namespace mpmvv::reports
