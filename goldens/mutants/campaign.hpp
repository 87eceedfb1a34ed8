#pragma once
#include <functional>
#include <string>
#include <vector>

#include "goldens/mutants/bench.hpp"

namespace mpmvv {

/// A mutant to be tried, and its edit.
struct Candidate {
  Mutant mutant;  ///< without trials
  Edit edit;
};

/// What a campaign tries.
struct CampaignPlan {
  std::vector<Candidate> planted;
  std::vector<Candidate> draws;  ///< random ones, in the order of the draw; those that do not compile are passed over
  int random = 0;                ///< how many of these that compile
};

/// Where a campaign's results come from and go to.
struct CampaignStore {
  std::function<const Mutant*(const Mutant&)> find;  ///< what is known of a mutant with this name, gate and edit
  std::function<void(const Mutant&)> keep;           ///< called after every trial
  std::function<void(const std::string&)> tell;      ///< progress, a line
};

/// Takes the tree without a mistake through the stages, then planted mistakes through the unit tests and the quick
/// gate, random ones through the quick gate and, those that it does not catch, the unit tests; at last whatever has
/// survived through the nightly gate. What is known is not done again. UsageError when the tree does not build or does
/// not pass: a gate that fails on it proves nothing. The baseline comes first, the others in the order of the plan.
std::vector<Mutant> run_campaign(const CampaignPlan& plan, const std::string& gate, Bench& bench,
                                 const CampaignStore& store);

}  // namespace mpmvv
