#pragma once
#include <string>

#include "goldens/gate.hpp"

namespace mpmvv::goldens {

/// Workflow commands of GitHub Actions, a line each, that mark the goldens in a change: `::error` for what failed,
/// `::warning` for what is inconclusive, and one `::notice` for all whose study the store has nothing of.
std::string github_annotations(const GateReport& report);

}  // namespace mpmvv::goldens
