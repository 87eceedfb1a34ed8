#pragma once
#include <cstddef>
#include <set>
#include <string>

namespace mpmvv::codes {

/// Returns the name of a condition, `is_per_particle` for the prefix `is_` and the word per-particle.
std::string condition_name(const std::string& prefix, std::string word);

/// Returns the name of a face, counted as xmin, xmax, ymin, ...
std::string face_name(std::size_t face);

/// Returns the names of all fields that some case gives templates, or their particles, but for parameters of problems.
const std::set<std::string>& names_of_fields();

/// Whether some case gives templates, or their particles, a field of this name.
bool is_field_of_case(const std::string& name);

}  // namespace mpmvv::codes
