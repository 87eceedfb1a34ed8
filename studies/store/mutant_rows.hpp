#pragma once
#include <string>
#include <vector>

#include "studies/mutant.hpp"
#include "studies/store/database.hpp"
#include "studies/store/provenance.hpp"

namespace mpmvv::store {

/// A mutant as its rows hold it.
struct StoredMutant {
  Mutant mutant;
  Provenance provenance;
};

/// Inserts a mutant, in the place of the one with this name, digest and gate.
void insert_mutant(Database& database, const StoredMutant& stored);

/// Mutants of this digest, in the order of their last keeping.
std::vector<StoredMutant> load_mutants(const Database& database, const std::string& digest);

/// Copies the mutants that `to` lacks.
void copy_mutants(const Database& from, Database& to);

}  // namespace mpmvv::store
