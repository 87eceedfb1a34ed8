#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tests/mutation/campaign.hpp"
#include "tests/mutation/mistake.hpp"
#include "tests/mutation/scratch_tree.hpp"

namespace mpmvv::mutation {

/// The random mutations that are wanted of a tree.
struct Draw {
  int count = 0;
  std::uint64_t seed = 0;
};

/// Mistakes and random mutations of the tree, to be tried by the gate of this digest, without what is known of them.
/// UsageError unless every mistake can be made there.
CampaignPlan plan_of(const std::vector<Mistake>& mistakes, const Draw& draw, const ScratchTree& tree,
                     const std::string& gate);

/// Keeps only the mutants of these names; all when none is named. UsageError for a name that no mutant has.
void keep_named(CampaignPlan& plan, const std::vector<std::string>& names);

}  // namespace mpmvv::mutation
