#pragma once
#include <array>
#include <string>
#include <vector>

#include "studies/records/result.hpp"

namespace mpmvv::claims {

using support::to_string;

/// A criterion of a claim as one study judged it.
struct JudgedPart {
  std::string study;
  records::ClaimPart part;
};

/// The verdict on one claim.
struct Claim {
  enum class Verdict { confirmed, partly, refuted, shown, open };

  std::string id;
  std::string statement;  ///< empty where an older store does not keep it
  std::string source;     ///< the paper, "Steffen et al. 2008"
  std::string where;      ///< the place in it, "Fig. 10"
  Verdict verdict = Verdict::open;
  std::string evidence;                   ///< per part: what was asked and measured
  std::vector<JudgedPart> parts;          ///< in the order of the studies
  std::vector<std::string> studies;       ///< those that have a part of it
  std::vector<std::string> not_run = {};  ///< studies that judge it, too, but have no result here
};

constexpr std::array<const char*, 5> words_of(Claim::Verdict) {
  return {"confirmed", "partly", "refuted", "shown", "open"};
}

/// The claims that the studies name, in the order of the studies that state them (s-fig4 before s-fig10), judged from
/// the parts that the studies hold, figures aside: `confirmed` when all parts hold, `refuted` when some fail and none
/// holds, `partly` when some hold and others do not, `shown` when only figures are asked for, `open` without a part or
/// when all are inconclusive. A study that is not among `studies` has no part in this; `not_run` is left to who knows
/// it.
std::vector<Claim> judge_claims(const std::vector<records::StudyResult>& studies);

}  // namespace mpmvv::claims
