#pragma once
#include "studies/records/record.hpp"

namespace mpmvv::cli {

/// Prints what came of one case: how it was run, errors, what must not change, cost.
void print_record(const records::Record& r);

}  // namespace mpmvv::cli
