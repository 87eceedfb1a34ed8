#pragma once
#include "studies/records/result.hpp"

namespace mpmvv::cli {

/// Prints why runs failed, and why those of other codes are unstable; with `verbose` those of our own solver, too.
void print_run_reasons(const records::StudyResult& study, bool verbose);

}  // namespace mpmvv::cli
