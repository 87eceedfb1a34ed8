#pragma once
#include <vector>

#include "studies/records/record.hpp"
#include "studies/store/database.hpp"

namespace mpmvv::store {

/// The errors as a text: a line "x y error" for each particle, with five digits, which is enough for a figure. NULL
/// without any.
Value value_of(const std::vector<records::ParticleError>& errors);

/// The errors in such a text; none for NULL.
std::vector<records::ParticleError> particle_errors_of(const Value& value);

}  // namespace mpmvv::store
