#pragma once
#include "studies/records/record.hpp"

namespace mpmvv::cli {

/// Prints what came of one case: how it was run, errors, what must not change, cost.
void print_record(const records::Record& r);

/// Prints the record of what another code has written in these files, with so many digits.
void print_score(const records::Record& r, const std::string& files, int digits);

}  // namespace mpmvv::cli
