#pragma once
#include <vector>

#include "reports/alarm_counts.hpp"
#include "reports/mutation_results.hpp"
#include "reports/table.hpp"

namespace mpmvv::reports {

/// The score; the planted mistakes, and what caught them; the random ones that nothing has caught; runs without a
/// mistake. Each is left out where there is nothing to show.
std::vector<Table> mutant_tables(const MutationResults& mutation, const std::vector<AlarmCount>& alarms);

}  // namespace mpmvv::reports
