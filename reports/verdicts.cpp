#include "reports/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace mpmvv::reports {

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

std::string gate_counts(const std::vector<GateLine>& lines) {
  return counts(verdicts(lines), {"fail", "inconclusive", "pass"});
}

std::string claim_counts(const std::vector<claims::Claim>& claims) {
  return counts(verdicts(claims), {"confirmed", "partly", "refuted", "shown", "open"});
}

std::string gate_verdict(const std::vector<GateLine>& lines) {
  const auto has = [&](const char* word) { return std::ranges::find(lines, word, &GateLine::verdict) != lines.end(); };
  return lines.empty() ? "not judged" : has("fail") ? "fail" : has("inconclusive") ? "inconclusive" : "pass";
}

std::vector<GateGroup> gate_groups(const std::vector<GateLine>& lines) {
  std::vector<GateGroup> groups;
  for (const GateLine& line : lines) {
    auto group = std::ranges::find(groups, line.study, &GateGroup::study);
    if (group == groups.end()) group = groups.insert(groups.end(), {line.study, {}});
    group->lines.push_back(line);
  }
  std::ranges::stable_partition(groups, [](const GateGroup& g) { return gate_verdict(g.lines) != "pass"; });
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

ClaimSplit claim_split(const ReportInput& input) {
  ClaimSplit split;
  for (const claims::Claim& claim : input.claims) {
    const bool is_named = std::ranges::any_of(input.studies, [&](const records::StudyResult& study) {
      return std::ranges::find(study.claims, claim.id) != study.claims.end();
    });
    (is_named || !claim.parts.empty() ? split.judged : split.without_study).push_back(claim);
  }
  return split;
}

}  // namespace mpmvv::reports
