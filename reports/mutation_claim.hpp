#pragma once
#include <optional>
#include <vector>

#include "reports/alarm_log.hpp"
#include "reports/mutation_results.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// What planted mistakes and runs without a mistake say on claim X-mutants, as the parts of a study; without parts when
/// no mistake is known.
records::StudyResult mutation_study(const std::optional<MutationResults>& mutation, const std::vector<AlarmRun>& runs);

}  // namespace mpmvv::reports
