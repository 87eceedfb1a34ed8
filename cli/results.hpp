#pragma once
#include <string>
#include <vector>

#include "goldens/mutants/alarm_log.hpp"
#include "goldens/mutants/mistake.hpp"
#include "goldens/mutants/tried.hpp"
#include "studies/claims/trend.hpp"
#include "studies/store/provenance.hpp"
#include "studies/store/store.hpp"

namespace mpmvv::cli {

/// What the store holds of the running program's own digest.
inline std::vector<records::StudyResult> own_results(const std::string& db) {
  return store::Store(db, store::Store::Mode::read).studies(store::current_provenance().digest);
}

/// How the gate took this program's mutants: what its store knows and the goldens' folder publishes, by the lists
/// there.
inline std::vector<Mutant> own_mutants(const store::Store& store, const std::string& goldens) {
  const auto folder = std::filesystem::path(goldens) / "mutants";
  const std::string digest = store::current_provenance().digest;
  TriedMutants tried = read_tried(folder);
  if (tried.digest != digest) tried.mutants.clear();
  return reviewed(newest(with_published(store.mutants(digest), tried.mutants)), folder);
}

/// The published runs without a mistake, of this program's sources.
inline std::vector<AlarmRun> own_alarms(const std::string& goldens) {
  AlarmLog log = read_alarms(std::filesystem::path(goldens) / "mutants");
  if (log.digest != store::current_provenance().digest) log.runs.clear();
  return log.runs;
}

/// The studies, and what the mutants and the runs without a mistake say on their claim.
inline std::vector<records::StudyResult> with_mutants(std::vector<records::StudyResult> studies,
                                                      const std::vector<Mutant>& mutants,
                                                      const std::vector<AlarmRun>& alarms) {
  studies.push_back(mutant_study(mutants, alarms));
  return studies;
}

/// The trends over these versions of a store.
inline std::vector<claims::Trend> trends_in(const store::Store& store, const std::vector<store::Version>& versions) {
  std::vector<std::vector<claims::Finding>> findings;
  for (const store::Version& version : versions) findings.push_back(claims::findings_of(store.studies(version.digest)));
  return claims::trends_of(findings);
}

}  // namespace mpmvv::cli
