#pragma once
#include "goldens/gate.hpp"

namespace mpmvv::cli {

/// Prints what fails, then what is inconclusive, what the store has nothing of in one line, and how many there are of
/// each; with `verbose` also what passes, and each golden that the store has nothing of.
void print_gate(const goldens::GateReport& report, bool verbose);

}  // namespace mpmvv::cli
