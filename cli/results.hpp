#pragma once
#include <string>
#include <vector>

#include "studies/provenance.hpp"
#include "studies/store.hpp"

namespace mpmvv {

/// What the store holds of the running program's own digest.
inline std::vector<StudyResult> own_results(const std::string& db) {
  return Store(db, Store::Mode::read).studies(current_provenance().digest);
}

}  // namespace mpmvv
