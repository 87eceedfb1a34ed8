#pragma once
#include <vector>

#include "goldens/gate.hpp"
#include "studies/store/code_series.hpp"

namespace mpmvv::cli {

/// Prints what fails, then what is inconclusive, what the store has nothing of in one line, and how many there are of
/// each; with `verbose` also what passes, and each golden that the store has nothing of. `judged` are the codes whose
/// results are judged, one series of each in each study.
void print_gate(const goldens::GateReport& report, const std::vector<store::CodeSeries>& judged, bool verbose);

}  // namespace mpmvv::cli
