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

/// The work of each of so many machines: together all of it, each case once. Of one machine are: a check; the search of
/// a limit, with all cases that it may probe; what is timed in a study, which takes turns. The longest comes first and
/// goes to the machine that has least. The same for the same studies and costs.
std::vector<Work> split(const std::vector<StudyPlan>& plans, const CostModel& costs, std::size_t shards);

/// What a machine needs for its work, by estimate.
struct Demand {
  double seconds = 0;  ///< on so many jobs
  double memory = 0;   ///< bytes, of the cases that may run at once
};

Demand demand(const std::vector<StudyPlan>& plans, const Work& work, const CostModel& costs, int jobs);

}  // namespace mpmvv::plan
