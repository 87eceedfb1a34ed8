#pragma once
#include <string>
#include <vector>

#include "studies/records/result.hpp"

namespace mpmvv::claims {

/// The verdict on one row of the list of claims.
struct Claim {
  std::string id;
  std::string statement;
  std::string verdict;               ///< `confirmed`, `refuted`, `partly`, `shown`, `open`
  std::string evidence;              ///< per part: what was asked and measured
  std::vector<std::string> studies;  ///< where the evidence stands
};

/// Every claim of the list, judged from the parts that the studies hold: `confirmed` when all parts hold, `refuted`
/// when none does, `partly` in between, `shown` when only figures are asked for, `open` without a study or while
/// a part is inconclusive and nothing else is known.
std::vector<Claim> judge_claims(const std::vector<records::StudyResult>& studies);

/// Ids and statements of all claims.
struct ClaimText {
  const char* id;
  const char* statement;
};
const std::vector<ClaimText>& claim_list();

}  // namespace mpmvv::claims
