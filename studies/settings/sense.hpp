#pragma once
#include "studies/cases/case.hpp"

namespace mpmvv::settings {

/// Throws UsageError on a combination of words that makes no sense, and says why.
void require_sense(const cases::Case& c);

}  // namespace mpmvv::settings
