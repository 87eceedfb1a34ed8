#include "studies/claims/claim.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <set>

namespace mpmvv::claims {

using records::ClaimText;
using records::PartVerdict;
using records::StudyResult;

namespace {

Claim::Verdict verdict_of(const std::vector<JudgedPart>& parts) {
  const auto count = [&parts](PartVerdict v) {
    return std::ranges::count_if(parts, [v](const JudgedPart& judged) { return judged.part.verdict == v; });
  };
  const auto holds = count(PartVerdict::holds), fails = count(PartVerdict::fails);
  const auto unknown = count(PartVerdict::inconclusive);
  using enum Claim::Verdict;
  if (holds == 0 && fails == 0) return unknown == 0 && !parts.empty() ? shown : open;
  if (fails == 0 && unknown == 0) return confirmed;
  return holds == 0 ? refuted : partly;
}

std::string evidence_of(const std::vector<JudgedPart>& parts) {
  std::vector<std::string> texts;
  for (const auto& [study, part] : parts) {
    const std::string& why = part.reason.empty() ? part.withheld : part.reason;
    const std::string reason = why.empty() ? "" : " Reason: " + why;
    texts.push_back(fmt::format("{}: {} [{}].{}", part.statement, part.evidence, to_string(part.verdict), reason));
  }
  return fmt::format("{}", fmt::join(texts, "\n"));
}

/// The text of a claim as the study that states it has it; without that study's results, as another study has copied
/// it.
ClaimText text_of(const std::string& id, const std::vector<StudyResult>& studies) {
  ClaimText text{id, "", "", "", ""};
  for (const StudyResult& study : studies)
    for (const ClaimText& known : study.statements) {
      if (known.id != id) continue;
      if (known.study == study.name) return known;
      if (text.study.empty()) text = known;
    }
  return text;
}

/// Each claim that some study names, once, in the order of the studies that state them. A claim whose stating study is
/// unknown stands with the first study that names it.
std::vector<ClaimText> claim_texts(const std::vector<StudyResult>& studies) {
  std::vector<ClaimText> texts;
  std::set<std::string> ids;
  for (const StudyResult& study : studies)
    for (const std::string& id : study.claims) {
      if (!ids.insert(id).second) continue;
      texts.push_back(text_of(id, studies));
      if (texts.back().study.empty()) texts.back().study = study.name;
    }
  std::ranges::stable_sort(
      texts, [](const ClaimText& a, const ClaimText& b) { return strverscmp(a.study.c_str(), b.study.c_str()) < 0; });
  return texts;
}

}  // namespace

std::vector<Claim> judge_claims(const std::vector<StudyResult>& studies) {
  std::vector<Claim> claims;
  for (const ClaimText& text : claim_texts(studies)) {
    Claim claim{text.id, text.statement, text.source, text.where, verdict_of({}), "", {}, {}};
    for (const StudyResult& study : studies)
      for (const records::ClaimPart& part : study.parts) {
        if (part.claim != claim.id) continue;
        claim.parts.push_back({study.name, part});
        if (claim.studies.empty() || claim.studies.back() != study.name) claim.studies.push_back(study.name);
      }
    claim.verdict = verdict_of(claim.parts);
    claim.evidence = evidence_of(claim.parts);
    claims.push_back(claim);
  }
  return claims;
}

}  // namespace mpmvv::claims
