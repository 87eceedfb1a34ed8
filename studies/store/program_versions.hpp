#pragma once
#include <vector>

#include "studies/store/database.hpp"
#include "studies/store/version.hpp"

namespace mpmvv::store {

/// The versions of this program that studies were kept of, by the time of their first run, or, without runs, of their
/// first study as it was kept last.
std::vector<Version> versions_of_program(const Database& database);

}  // namespace mpmvv::store
