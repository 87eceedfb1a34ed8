#pragma once
#include <vector>

#include "reports/table.hpp"
#include "studies/mutant.hpp"

namespace mpmvv::reports {

/// The score; the planted mistakes, and what caught them; the random ones that nothing has caught; runs without a
/// mistake. Empty without any mutant.
std::vector<Table> mutant_tables(const std::vector<Mutant>& mutants, const std::vector<AlarmRun>& alarms);

}  // namespace mpmvv::reports
