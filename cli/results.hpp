#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/shipped.hpp"
#include "cli/study_list.hpp"
#include "reports/alarm_counts.hpp"
#include "reports/mutation_claim.hpp"
#include "reports/mutation_results.hpp"
#include "reports/origin.hpp"
#include "studies/claims/claim.hpp"
#include "studies/claims/trend.hpp"
#include "studies/store/provenance.hpp"
#include "studies/store/store.hpp"
#include "studies/store/trial.hpp"
#include "studies/support/error.hpp"

namespace mpmvv::cli {

inline bool is_trial(const records::StudyResult& study) {
  return !store::trial_of(study.text).empty();
}

/// Makes a trial (`study --set`) inconclusive on its claims, as the gate makes it on its goldens.
inline void withhold_verdicts(records::StudyResult& trial) {
  for (records::ClaimPart& part : trial.parts)
    if (part.verdict != records::PartVerdict::shown) {
      part.verdict = records::PartVerdict::inconclusive;
      part.withheld = fmt::format("made with --set: {}", store::trial_of(trial.text));
      part.reason = "";
    }
}

/// What the store holds of these sources.
inline std::vector<records::StudyResult> results_of(const store::Store& store, const std::string& digest) {
  auto studies = store.studies(digest);
  for (records::StudyResult& study : studies)
    if (is_trial(study)) withhold_verdicts(study);
  return studies;
}

/// What the store holds of the running program's own digest.
inline std::vector<records::StudyResult> own_results(const std::string& db) {
  return results_of(store::Store(db, store::Store::Mode::read), store::current_provenance().digest);
}

/// Throws where there is no study: says of which versions the store has some.
inline void require_own_results(const std::vector<records::StudyResult>& studies, const std::string& db) {
  if (!studies.empty()) return;
  std::vector<std::string> others;
  for (const store::Version& version : store::Store(db, store::Store::Mode::read).versions())
    others.push_back(label(version));
  if (others.empty())
    throw support::UsageError(fmt::format("{} holds no study of this program (run `mpmvv study` first)", db));
  throw support::UsageError(
      fmt::format("{} holds no study of this program, whose digest is {}, but of {} (run `mpmvv study` first; `mpmvv "
                  "figure` can also draw results of another version, with --of)",
                  db, store::in_short(store::current_provenance().digest), fmt::join(others, ", ")));
}

/// Where these results of the running program's own digest come from.
inline reports::Provenances provenances_of(const std::vector<records::StudyResult>& studies,
                                           const store::Store& store) {
  reports::Provenances provenances;
  for (const records::StudyResult& study : studies)
    if (auto kept = store.study_provenance(study.name, store::current_provenance().digest))
      provenances[study.name] = std::move(*kept);
  return provenances;
}

/// What comes with the program of the results that the mutation campaign and `./run alarms` publish: the file of this
/// name. Empty where nothing comes with the program.
inline std::filesystem::path published(const std::string& file) {
  const std::filesystem::path folder = shipped("tests/mutation");
  return folder.empty() ? folder : folder / file;
}

/// What `./run mutants` leaves beside a store.
inline std::filesystem::path mutants_beside(const std::string& db) {
  return std::filesystem::path(db).parent_path() / "mutants.json";
}

/// The results of this program's mutants: those that `./run mutants` left beside the store or those that are published,
/// whichever tried more mutants.
inline std::optional<reports::MutationResults> own_mutation(const std::string& db) {
  const std::string digest = store::current_provenance().digest;
  std::optional<reports::MutationResults> most;
  for (const auto& file : {mutants_beside(db), published("summary.json")}) {
    auto results = reports::read_mutation_results(file);
    if (results && results->digest == digest && (!most || results->tried() > most->tried())) most = std::move(results);
  }
  return most;
}

/// The published runs of programs without a mistake (`./run alarms`); none where they are of other sources than this
/// program.
inline std::vector<reports::AlarmCount> own_alarms() {
  reports::AlarmCounts counts = reports::read_alarms(published("alarms.toml"));
  if (counts.digest != store::current_provenance().digest) counts.builds.clear();
  return counts.builds;
}

/// The claims as the studies of a store judge them. The claim on mutants, where a study names it, is judged by the
/// mutants and by the runs without a mistake.
inline std::vector<claims::Claim> judged_claims(std::vector<records::StudyResult> studies,
                                                const std::optional<reports::MutationResults>& mutation) {
  const records::StudyResult mutants = reports::mutation_study(mutation, own_alarms());
  const auto names_it = [&](const records::StudyResult& study) {
    return std::ranges::find(study.claims, mutants.claims.front()) != study.claims.end();
  };
  if (std::ranges::any_of(studies, names_it)) studies.push_back(mutants);
  std::vector<claims::Claim> judged = claims::judge_claims(studies);
  name_studies_not_run(judged, studies);
  return judged;
}

inline std::vector<records::StudyResult> without_trials(std::vector<records::StudyResult> studies) {
  std::erase_if(studies, is_trial);
  return studies;
}

/// The studies by which versions of our own program are compared: those that are no trials, without the series of other
/// codes, which have versions of their own, and without the criteria on them.
inline std::vector<records::StudyResult> own_evidence(std::vector<records::StudyResult> studies) {
  studies = without_trials(std::move(studies));
  std::erase_if(studies, [](const records::StudyResult& study) {
    return !study.series.empty() && std::ranges::all_of(study.series, records::is_of_another_code);
  });
  for (records::StudyResult& study : studies) {
    std::vector<records::Series> theirs;
    std::ranges::copy_if(study.series, std::back_inserter(theirs), records::is_of_another_code);
    std::erase_if(study.parts, [&](const records::ClaimPart& part) { return records::speaks_of(part, theirs); });
    std::erase_if(study.series, records::is_of_another_code);
  }
  return studies;
}

/// The versions in a store, by time: of our own program, or of another code.
inline std::vector<store::Version> versions_in(const store::Store& store, const std::string& code) {
  return code.empty() ? store.versions() : store.versions_of_code(code);
}

inline std::vector<claims::Finding> findings_in(const store::Store& store, const std::string& code,
                                                const store::Version& version) {
  return claims::findings_of(code.empty() ? own_evidence(store.studies(version.digest))
                                          : store.studies_of_code(code, version));
}

/// The trends over these versions of a store.
inline std::vector<claims::Trend> trends_in(const store::Store& store, const std::string& code,
                                            const std::vector<store::Version>& versions) {
  std::vector<std::vector<claims::Finding>> findings;
  for (const store::Version& version : versions) findings.push_back(findings_in(store, code, version));
  return claims::trends_of(findings);
}

}  // namespace mpmvv::cli
