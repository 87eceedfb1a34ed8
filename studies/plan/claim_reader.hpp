#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "studies/plan/study.hpp"
#include "studies/support/toml_file.hpp"

namespace mpmvv::plan {

/// The claims that a study file states: every [[claim]], with id, statement and, where there is one, its source and
/// the place in it.
std::vector<StatedClaim> read_claims(const support::TomlTable& root, const std::string& study);

/// Gives each plan what the claims say that it names and does not state: as another of the plans states them, or else a
/// study file in one of the folders, the first one first. UsageError where none does, and where two say different
/// things of one claim.
void state_claims(std::vector<StudyPlan>& plans, const std::vector<std::filesystem::path>& folders);

/// UsageError where a plan says something else of a claim than a study of the store does that is not among the plans.
void require_one_voice(const std::vector<StudyPlan>& plans, const std::vector<records::ClaimText>& stored,
                       const std::string& db);

}  // namespace mpmvv::plan
