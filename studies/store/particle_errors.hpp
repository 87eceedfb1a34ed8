#pragma once
#include <vector>

#include "studies/records/record.hpp"
#include "studies/store/database.hpp"

namespace mpmvv::store {

/// As a text of a line for each, with five digits: enough for a figure. NULL where there are none.
Value value_of(const std::vector<records::ParticleError>& errors);

/// What such a text holds.
std::vector<records::ParticleError> particle_errors_of(const Value& value);

}  // namespace mpmvv::store
