#include "cli/earlier.hpp"

#include <algorithm>

#include "cli/change_text.hpp"
#include "cli/results.hpp"
#include "goldens/gate.hpp"
#include "studies/claims/claim.hpp"

namespace mpmvv::cli {

namespace {

/// The version before that of this digest, by the times of their first results; null without one.
const store::Version* version_before(const std::vector<store::Version>& versions, const std::string& digest) {
  const auto now = std::ranges::find(versions, digest, &store::Version::digest);
  return now == versions.begin() || now == versions.end() ? nullptr : &*(now - 1);
}

bool has_study(const std::vector<records::StudyResult>& studies, const std::string& name) {
  return std::ranges::find(studies, name, &records::StudyResult::name) != studies.end();
}

/// Sets how the gate judges the goldens of the studies that both versions have.
void compare_gates(std::vector<goldens::Golden> goldens, const std::vector<records::StudyResult>& then,
                   const std::vector<records::StudyResult>& now, reports::Earlier& earlier) {
  std::erase_if(goldens, [&](const goldens::Golden& golden) {
    return !has_study(then, golden.study) || !has_study(now, golden.study);
  });
  earlier.goldens_compared = goldens.size();
  if (goldens.empty()) return;
  const auto judged_then = goldens::run_gate(goldens, then).results,
             judged_now = goldens::run_gate(goldens, now).results;
  for (std::size_t i = 0; i < goldens.size(); ++i)
    if (judged_then[i].verdict != judged_now[i].verdict)
      ++earlier.gate_change[{judged_then[i].verdict, judged_now[i].verdict}];
}

std::vector<double> ratios_of(const std::vector<goldens::Change>& costs) {
  std::vector<double> ratios;
  for (const goldens::Change& cost : costs)
    if (cost.before.number > 0 && cost.after.number > 0) ratios.push_back(cost.after.number / cost.before.number);
  return ratios;
}

/// What the earlier version has and this one lacks, of the studies that both have.
std::vector<std::string> results_gone(std::vector<records::StudyResult> then, std::vector<records::StudyResult> now) {
  std::erase_if(then, [&](const records::StudyResult& study) { return !has_study(now, study.name); });
  std::erase_if(now, [&](const records::StudyResult& study) { return !has_study(then, study.name); });
  return goldens::compare(claims::findings_of(then), claims::findings_of(now)).only_before;
}

/// The earlier verdicts on claims that the same studies judge now. What a campaign found of the earlier version's
/// mutants is not known any more.
std::map<std::string, claims::Claim::Verdict> verdicts_then(const std::vector<records::StudyResult>& then,
                                                            const std::vector<records::StudyResult>& now) {
  std::map<std::string, claims::Claim::Verdict> verdicts;
  const auto claims_now = claims::judge_claims(now);
  for (const claims::Claim& claim : claims::judge_claims(then)) {
    const auto same = std::ranges::find(claims_now, claim.id, &claims::Claim::id);
    if (same == claims_now.end() || claim.id == reports::mutants_claim) continue;
    if (!claim.studies.empty() && std::ranges::is_permutation(claim.studies, same->studies))
      verdicts[claim.id] = claim.verdict;
  }
  return verdicts;
}

}  // namespace

reports::Changes changes_of(const goldens::Comparison& comparison) {
  reports::Changes changes{comparison.changes.size(), {}, {}};
  for (const goldens::Change& change : comparison.changes) {
    const std::string& study = change.before.study;  // a claim's verdict belongs to none
    if (change.bands != 0)
      changes.differ.push_back(study.empty() ? change_text(change) : study + ": " + change_text(change));
  }
  return changes;
}

std::optional<reports::Earlier> earlier_version(const store::Store& store, const std::vector<goldens::Golden>& goldens,
                                                const std::vector<records::StudyResult>& now) {
  const auto versions = store.versions();
  const store::Version* version = version_before(versions, store::current_provenance().digest);
  if (version == nullptr) return std::nullopt;
  const auto all_then = without_trials(store.studies(version->digest)), all_now = without_trials(now);
  const auto then = own_evidence(all_then), own_now = own_evidence(now);
  const goldens::Comparison comparison = goldens::compare(claims::findings_of(then), claims::findings_of(own_now));
  reports::Earlier earlier;
  earlier.label = store::in_short(version->commits.front());
  compare_gates(goldens, all_then, all_now, earlier);
  earlier.claims = verdicts_then(all_then, all_now);
  earlier.changes = changes_of(comparison);
  earlier.changes.gone = results_gone(then, own_now);
  earlier.cost_ratios = ratios_of(comparison.costs);
  return earlier;
}

}  // namespace mpmvv::cli
