#pragma once
#include "studies/cases/case.hpp"

namespace mpmvv {

/// Throws UsageError on a combination of words that makes no sense, and says why.
void require_sense(const Case& c);

}  // namespace mpmvv
