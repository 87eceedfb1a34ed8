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

/// Adds to each plan the claims that it names but does not state itself: as another of the plans states them, else as a
/// study file in one of the folders does, searched in their order. UsageError when nobody states a claim, and when two
/// state it differently.
void state_claims(std::vector<StudyPlan>& plans, const std::vector<std::filesystem::path>& folders);

/// UsageError when a plan states a claim differently from a study in the store that is not among the plans. `db` names
/// the store in the message.
void require_one_voice(const std::vector<StudyPlan>& plans, const std::vector<records::ClaimText>& stored,
                       const std::string& db);

}  // namespace mpmvv::plan
