#pragma once
#include <string>
#include <vector>

#include "studies/provenance.hpp"
#include "studies/store.hpp"
#include "studies/trend.hpp"

namespace mpmvv {

/// What the store holds of the running program's own digest.
inline std::vector<StudyResult> own_results(const std::string& db) {
  return Store(db, Store::Mode::read).studies(current_provenance().digest);
}

/// The trends over these versions of a store.
inline std::vector<Trend> trends_in(const Store& store, const std::vector<Version>& versions) {
  std::vector<std::vector<Finding>> findings;
  for (const Version& version : versions) findings.push_back(findings_of(store.studies(version.digest)));
  return trends_of(findings);
}

}  // namespace mpmvv
