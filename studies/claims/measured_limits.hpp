#pragma once
#include "studies/claims/measured.hpp"

/// Numbers measured for criteria on stability limits.
namespace mpmvv::claims {

void measure_limit(const records::Series& series, Measured& out);

/// The limit of a series over that of another.
void measure_limit_ratio(const records::Series& series, const records::Series& over, Measured& out);

}  // namespace mpmvv::claims
