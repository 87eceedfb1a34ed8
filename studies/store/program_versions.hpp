#pragma once
#include <vector>

#include "studies/store/database.hpp"
#include "studies/store/version.hpp"

namespace mpmvv::store {

/// The versions of this program that studies were kept of, by the time of their first result.
std::vector<Version> versions_of_program(const Database& database);

}  // namespace mpmvv::store
