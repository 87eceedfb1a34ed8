#pragma once
#include "studies/records/result.hpp"

namespace mpmvv::cli {

/// Prints what came of a study: its errors, orders, limits and values as tables, and what its criteria say; with
/// `verbose` also on what grounds.
void print_study(const records::StudyResult& study, bool verbose);

}  // namespace mpmvv::cli
