#include "reports/verdicts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>

namespace mpmvv::reports {

using records::Verdict;

namespace {

template <class Line, class Word>
std::string counts(const std::vector<Line>& lines, std::initializer_list<Word> order) {
  std::vector<std::string> texts;
  for (const Word verdict : order)
    if (const auto count = std::ranges::count(lines, verdict, &Line::verdict); count > 0)
      texts.push_back(fmt::format("{} {}", count, to_string(verdict)));
  return texts.empty() ? "none" : fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

std::string gate_counts(const std::vector<GateLine>& lines) {
  return counts(lines, {Verdict::fail, Verdict::inconclusive, Verdict::pass});
}

std::string claim_counts(const std::vector<claims::Claim>& claims) {
  using enum claims::Claim::Verdict;
  return counts(claims, {confirmed, partly, refuted, shown, open});
}

bool is_own(const claims::Claim& claim) {
  return claim.source.empty() || claim.source == "mpmvv";
}

std::optional<Verdict> gate_verdict(const std::vector<GateLine>& lines) {
  for (const Verdict verdict : {Verdict::fail, Verdict::inconclusive, Verdict::pass})
    if (std::ranges::count(lines, verdict, &GateLine::verdict) > 0) return verdict;
  return std::nullopt;
}

std::string gate_word(const std::vector<GateLine>& lines) {
  const auto verdict = gate_verdict(lines);
  return verdict ? to_string(*verdict) : "not judged";
}

std::vector<GateGroup> gate_groups(const std::vector<GateLine>& lines) {
  std::vector<GateGroup> groups;
  for (const GateLine& line : lines) {
    auto group = std::ranges::find(groups, line.study, &GateGroup::study);
    if (group == groups.end()) group = groups.insert(groups.end(), {line.study, {}});
    group->lines.push_back(line);
  }
  std::ranges::stable_partition(groups, [](const GateGroup& g) { return gate_verdict(g.lines) != Verdict::pass; });
  return groups;
}

GateSplit gate_split(const ReportInput& input) {
  GateSplit split;
  for (const GateLine& line : input.gate) {
    const bool is_here =
        std::ranges::find(input.studies, line.study, &records::StudyResult::name) != input.studies.end();
    (is_here ? split.judged : split.without_study).push_back(line);
  }
  return split;
}

std::string gate_word(const GateSplit& split) {
  const bool lacks_results = gate_verdict(split.judged) == Verdict::pass && !split.without_study.empty();
  return lacks_results ? to_string(Verdict::inconclusive) : gate_word(split.judged);
}

std::string gate_text(const GateSplit& split) {
  std::string verdict = gate_word(split.judged);
  if (split.judged.empty() || split.without_study.empty()) return verdict;
  return fmt::format("{}, {} without a result", verdict, split.without_study.size());
}

}  // namespace mpmvv::reports
