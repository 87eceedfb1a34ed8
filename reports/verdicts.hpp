#pragma once
#include <optional>
#include <string>
#include <vector>

#include "reports/report.hpp"

namespace mpmvv::reports {

/// "1 fail, 2 pass": verdicts in the order in which people look at them; "none" where there are none.
std::string gate_counts(const std::vector<GateLine>& lines);
std::string claim_counts(const std::vector<claims::Claim>& claims);

/// Whether no paper claims it.
bool is_own(const claims::Claim& claim);

/// The verdict on all of them together, which is the worst; none where there is no golden.
std::optional<records::Verdict> gate_verdict(const std::vector<GateLine>& lines);
std::string gate_word(const std::vector<GateLine>& lines);  ///< that verdict, or "not judged"

/// The goldens of one study.
struct GateGroup {
  std::string study;
  std::vector<GateLine> lines;
};

/// Goldens by study, those with something that does not pass first.
std::vector<GateGroup> gate_groups(const std::vector<GateLine>& lines);

/// Goldens that the report can judge, as their study is in it, and the others, whose study was not run here.
struct GateSplit {
  std::vector<GateLine> judged, without_study;
};
GateSplit gate_split(const ReportInput& input);

/// The verdict of the gate command, which is inconclusive where nothing fails and goldens have no result; in words
/// "pass, 421 without a result".
std::string gate_word(const GateSplit& split);
std::string gate_text(const GateSplit& split);

}  // namespace mpmvv::reports
