#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/mutation/bench.hpp"

namespace mpmvv::mutation {

/// A mutant to be tried, and its edit.
struct Candidate {
  Mutant mutant;  ///< without trials, with its reason where someone has explained it
  Edit edit;
};

/// What a campaign tries.
struct CampaignPlan {
  std::vector<Candidate> planted;
  std::vector<Candidate> draws;  ///< random ones, in the order of the draw; those that do not compile are passed over
  int random = 0;                ///< how many of these to try, counting those that compile
};

/// Where a campaign's results come from and go to.
struct CampaignStore {
  std::function<std::optional<Mutant>(const Mutant&)> find;  ///< what is known of it
  std::function<void(const Mutant&)> keep;                   ///< called after every trial
  std::function<void(const std::string&)> tell;              ///< progress, a line
};

/// What a store knows of a mutant: its trials by this gate. Failing that, where the sources are the same, the trials by
/// which an earlier version of the gate caught it: tests and goldens grow, so what they caught stays caught, but what
/// they let pass has to meet them again.
std::optional<Mutant> known_result(const std::vector<Mutant>& kept, const Mutant& wanted);

/// The edits that a campaign will ask for first: of all that is planted and as many random draws as are wanted, those
/// whose result is not known yet. More draws follow for those that do not compile.
std::vector<Edit> edits_to_try(const CampaignPlan& plan,
                               const std::function<std::optional<Mutant>(const Mutant&)>& find);

/// Takes the tree without a mistake through the stages, then planted mistakes through the unit tests and the quick
/// gate, random ones through the quick gate and, those that it does not catch, the unit tests; at last what has
/// survived through the nightly gate, unless it has a reason why nothing shows it. What is known is not done again.
/// UsageError when the tree does not build or does not pass: a gate that fails on it proves nothing. The baseline comes
/// first, the others in the order of the plan.
std::vector<Mutant> run_campaign(const CampaignPlan& plan, const std::string& gate, Bench& bench,
                                 const CampaignStore& store);

}  // namespace mpmvv::mutation
