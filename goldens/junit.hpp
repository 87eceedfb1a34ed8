#pragma once
#include <string>

#include "goldens/gate.hpp"

namespace mpmvv::goldens {

/// The gate as JUnit XML for CI tools: a suite per study, a case per golden; inconclusive ones count as skipped.
std::string junit_xml(const GateReport& report);

}  // namespace mpmvv::goldens
