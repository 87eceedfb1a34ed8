#pragma once
#include <optional>
#include <vector>

#include "reports/alarm_counts.hpp"
#include "reports/mutation_results.hpp"
#include "studies/records/result.hpp"

namespace mpmvv::reports {

/// The claim that is judged by planted mistakes and by runs without a mistake, and the command that makes both at the
/// top of the tree.
inline constexpr const char *mutants_claim = "X-mutants", *mutants_command = "./run mutants && ./run alarms";

/// What the planted mistakes and the runs without one say, as the parts of a study; without parts where no mistake is
/// known.
records::StudyResult mutation_study(const std::optional<MutationResults>& mutation,
                                    const std::vector<AlarmCount>& alarms);

}  // namespace mpmvv::reports
