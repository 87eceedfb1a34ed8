#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "studies/plan/cost_model.hpp"
#include "studies/plan/study.hpp"
#include "studies/plan/work.hpp"

namespace mpmvv::plan {

/// One of several machines that carry out studies together.
struct Shard {
  std::size_t number = 1, of = 1;
};

/// "2/8": UsageError when it has not that form.
Shard shard_from(const std::string& text);

/// Splits the work among so many machines: each case goes to one of them. A check stays on one machine; so does the
/// search of a limit with all cases that it may probe, and so do the timed cases of a study, which take turns. The
/// longest piece goes first, to the machine with the least work. The same studies and costs always give the same split,
/// so that each machine can work out its own share.
std::vector<Work> split(const std::vector<StudyPlan>& plans, const CostModel& costs, std::size_t shards);

/// What a machine needs for its work, by estimate.
struct Demand {
  double seconds = 0;  ///< on `jobs` cores
  double memory = 0;   ///< bytes, of the cases that may run at once
};

Demand demand(const std::vector<StudyPlan>& plans, const Work& work, const CostModel& costs, int jobs);

}  // namespace mpmvv::plan
