#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "reports/report.hpp"

namespace mpmvv::reports {

template <typename Lines>
std::vector<std::string> verdicts(const Lines& lines) {
  std::vector<std::string> words;
  for (const auto& line : lines) words.push_back(line.verdict);
  return words;
}

/// "2 pass, 1 fail": the words in this order, unknown ones after them; "none" where there are none.
std::string counts(const std::vector<std::string>& words, std::initializer_list<std::string> order);

/// The same of goldens and of claims, in the order in which people look at them.
std::string gate_counts(const std::vector<GateLine>& lines);
std::string claim_counts(const std::vector<claims::Claim>& claims);

/// `fail`, `inconclusive`, `pass`, or "not judged" where there is no golden.
std::string gate_verdict(const std::vector<GateLine>& lines);

/// The goldens of one study.
struct GateGroup {
  std::string study;
  std::vector<GateLine> lines;
};

/// Goldens by study, those with something that does not pass first.
std::vector<GateGroup> gate_groups(const std::vector<GateLine>& lines);

/// Goldens that the report can say something of: their study is in it. The others stand for what was not run here.
struct GateSplit {
  std::vector<GateLine> judged, without_study;
};
GateSplit gate_split(const ReportInput& input);

/// The claims that a study of the report judges or names; those that none does.
struct ClaimSplit {
  std::vector<claims::Claim> judged, without_study;
};
ClaimSplit claim_split(const ReportInput& input);

}  // namespace mpmvv::reports
