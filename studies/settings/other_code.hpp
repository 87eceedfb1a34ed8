#pragma once
#include "studies/problems/problem.hpp"
#include "studies/settings/given.hpp"

/// Cases that another code solves (`code`), which know nothing of our own solver's choices.
namespace mpmvv::settings {

/// UsageError on a key that cases of the chosen code do not have, and on one that belongs to another code without one.
void require_keys_of_code(const Settings& settings);

/// Throws UsageError with what is wrong where the code could not carry out a case, or nothing could be measured in it.
void validate_other_code(const cases::Case& c, const problems::Problem& problem);

}  // namespace mpmvv::settings
